// A formula as a tree: the step panel paints it as a textbook would, the command line prints it in one line.
#pragma once

#include <QString>

#include <vector>

namespace thetalane {

// The one colour code: who a symbol belongs to. The lane, the cards, the tables and the plots share it.
enum class Ink { Plain, First, Second, Along, Across, Triangle };

struct Formula {
    enum class Kind {
        Row,      // parts side by side
        Symbol,   // italic: v, m, Z, θ
        Upright,  // cos, sin, units
        Number,   // text as shown (four digits), exact as copied (all digits)
        Operator, // + − · = , spaced
        Fraction, // parts: above, below
        Root,     // parts: under the root
        Script, // parts: base, subscript, superscript (either may be an empty Row); a prime is a superscript
        Group,  // parts in parentheses that grow with them
    };

    Kind kind = Kind::Row;
    QString text;
    QString exact;
    Ink ink = Ink::Plain;
    std::vector<Formula> parts;
};

// Builders. A string literal of the code is a symbol of the field, never translated.
Formula row(std::vector<Formula> parts);
Formula symbol(const QString& text, Ink ink = Ink::Plain);
Formula upright(const QString& text, Ink ink = Ink::Plain);
Formula number(double value,
               Ink ink = Ink::Plain); // four significant digits; negative ones keep a true minus
// A number in parentheses where it is negative or has a power of ten.
Formula signedFactor(double value, Ink ink = Ink::Plain);
Formula op(const QString& text); // "+", "−", "·", "=", "≤"
Formula fraction(Formula above, Formula below);
Formula root(Formula under);
Formula script(Formula base, Formula sub, Formula super = {});
Formula group(Formula inner);

bool isEmpty(const Formula& formula); // a Row without parts: says nothing

enum class Digits { Four, All };

// One line of text: √(a² + b²), (m_A − e·m_B)/(m_A + m_B), v_Ax′, v′_ball,x. Factors side by side get a dot.
QString plainText(const Formula& formula, Digits digits = Digits::Four);

} // namespace thetalane
