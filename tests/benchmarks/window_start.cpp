// From the start of the program to a window that is painted and answers, in turn with an empty window of
// Qt's: each start is a process of its own, and the ratio is what the program adds to Qt.
#include "tests/benchmarks/table.h"
#include "tests/benchmarks/timing.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QProcess>
#include <QStandardPaths>
#include <QStyleFactory>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

using namespace thetalane;
using namespace thetalane::benchmarks;

namespace {

constexpr auto ready = "ready";

// Painted, and the events that led to it answered.
int showAndLeave(QWidget& window) {
    window.show();
    QCoreApplication::processEvents();
    window.repaint();
    QCoreApplication::processEvents();
    fputs(ready, stdout);
    fflush(stdout);
    return 0;
}

int emptyWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QWidget window;
    window.resize(1280, 800);
    auto* label = new QLabel("ThetaLane");
    auto* layout = new QVBoxLayout(&window);
    layout->addWidget(label);
    return showAndLeave(window);
}

int programWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    Language language;
    Session session;
    Appearance appearance;
    Playhead playhead{session};
    language.use(Language::Code::Korean);
    MainWindow window(Context{session, playhead, appearance}, language);
    return showAndLeave(window);
}

// [s], from before the process exists until it says that it is ready.
double startOf(const QString& program, const QString& what) {
    QElapsedTimer clock;
    clock.start();
    QProcess process;
    process.start(program, {"--child", what});
    while (!process.readAllStandardOutput().contains(ready))
        if (!process.waitForReadyRead(30'000))
            qFatal("a window did not start");
    const double taken = double(clock.nsecsElapsed()) * 1e-9;
    process.waitForFinished();
    return taken;
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace

int main(int argc, char** argv) {
    const QByteArray child = argc > 2 ? QByteArray(argv[2]) : QByteArray();
    if (child == "empty")
        return emptyWindow(argc, argv);
    if (child == "program")
        return programWindow(argc, argv);
    QCoreApplication application(argc, argv);
    const int rounds = QCoreApplication::arguments().contains("--quick") ? 2 : 21;
    std::vector<double> empty, program, ratio;
    for (int k = 0; k < rounds; ++k) {
        empty.push_back(startOf(QCoreApplication::applicationFilePath(), "empty"));
        program.push_back(startOf(QCoreApplication::applicationFilePath(), "program"));
        ratio.push_back(program.back() / empty.back());
    }
    Table table("**From start to a usable window**, off screen, each a process of its own, in turn.",
                {"starts", "an empty window of Qt's, median", "ThetaLane, median", "worst", "ratio, median"});
    const auto ms = [](double seconds) {
        return QString::number(1e3 * seconds, 'f', 0).toStdString() + " ms";
    };
    table.row({std::to_string(rounds), ms(medianOf(empty)), ms(medianOf(program)),
               ms(std::ranges::max(program)), QString::number(medianOf(ratio), 'f', 2).toStdString()});
    return 0;
}
