#include "app/look_text.h"

#include <QCoreApplication>

#include "app/changed_look.h"

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

QString nameText(const FittedLooks& looks, const std::string& lookName) {
    const NamedLook* look = looks.beginningOf(lookName);
    if (!look)
        return QString::fromStdString(lookName);
    const QString name = nameText(*look);
    return lookName == look->name ? name : QString::fromStdString(changedName(name.toStdString()));
}

QString doesNotShowText(const NamedLook& look) {
    return inWindow(look, look.doesNotShow);
}

QString doesNotShowText(const FittedLooks& looks, const PictureSetup& setup) {
    const NamedLook* look = looks.beginningOf(setup.lookName);
    const bool same = look && look->look.transferFunction == setup.look.transferFunction &&
                      look->look.visible == setup.look.visible && look->model == setup.model;
    return same ? doesNotShowText(*look) : QString();
}

QString unsuitedText(const std::string& reason) {
    return reason.empty() ? QString() : translated(reason);
}

}  // namespace pdr::app
