#include "ui/count_text.h"

namespace thetalane {

QString countText(std::int64_t count) {
    QString text = QString::number(count);
    if (text.size() < 5)
        return text;
    for (auto place = text.size() - 3; place > 0; place -= 3)
        text.insert(place, u',');
    return text;
}

} // namespace thetalane
