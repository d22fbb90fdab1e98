#include "app/look_text.h"

#include <QCoreApplication>

#include "app/document.h"

namespace pdr::app {
namespace {

/// Of a text that stands in the program's looks or in a room without Qt; see tests/translations/texts.py.
QString translated(const std::string& text) {
    return QCoreApplication::translate("looks", text.c_str());
}

QString inWindow(const NamedLook& look, const std::string& text) {
    return look.group == LookGroup::own ? QString::fromStdString(text) : translated(text);
}

}  // namespace

QString nameText(const NamedLook& look) {
    return inWindow(look, look.name);
}

QString nameText(const Document& document, const std::string& lookName) {
    const std::string changed = Document::tr(" (changed)").toStdString();
    for (const NamedLook& look : document.looks())
        for (const std::string& ending : {std::string(), changed})
            if (lookName == look.name + ending)
                return nameText(look) + QString::fromStdString(ending);
    return QString::fromStdString(lookName);
}

QString doesNotShowText(const NamedLook& look) {
    return inWindow(look, look.doesNotShow);
}

QString unsuitedText(const std::string& reason) {
    return reason.empty() ? QString() : translated(reason);
}

}  // namespace pdr::app
