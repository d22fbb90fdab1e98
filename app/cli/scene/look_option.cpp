#include "app/cli/scene/look_option.h"

#include "app/command_line/option_reader.h"
#include "app/looks/look_files.h"
#include "app/looks/looks.h"

namespace pdr::app {

NamedLook namedLook(const QString& text, const char* option) {
    const auto looks = bundledLooks();
    if (!looks)
        throw looks.error();
    if (isLookFile(text)) {
        const auto look = readLookFile(text, looks->front());
        if (!look)
            throw look.error();
        return *look;
    }
    std::string known;
    for (const NamedLook& look : *looks) {
        if (QString::fromStdString(look.name).compare(text, Qt::CaseInsensitive) == 0)
            return look;
        known += (known.empty() ? "" : ", ") + look.name;
    }
    usageError(option, "there is no look \"" + text.toStdString() + "\"", "There are: " + known + ".");
}

}  // namespace pdr::app
