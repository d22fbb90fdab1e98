#include "app/presenters/look_text.h"

#include <QCoreApplication>

namespace pdr::app {
namespace {

/// Translates a text of the bundled looks, or of code that knows no Qt; see tests/translations/texts.py.
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

QString nameText(const FittedLooks& looks, const std::string& title) {
    if (const NamedLook* look = looks.lookCalled(title))
        return nameText(*look);
    if (!title.ends_with(kChangedLook))
        return QString::fromStdString(title);
    const std::string name = title.substr(0, title.size() - kChangedLook.size());
    const NamedLook* look = looks.lookCalled(name);
    return translated("%1 (changed)").arg(look ? nameText(*look) : QString::fromStdString(name));
}

QString doesNotShowText(const NamedLook& look) {
    return inWindow(look, look.doesNotShow);
}

QString doesNotShowText(const FittedLooks& looks, const ImageSetup& setup) {
    const NamedLook* look = looks.beginningOf(setup);
    const bool same = look && look->look.transferFunction == setup.look.transferFunction &&
                      look->look.visible == setup.look.visible && look->model == setup.model;
    return same ? doesNotShowText(*look) : QString();
}

QString unsuitedText(const std::string& reason) {
    return reason.empty() ? QString() : translated(reason);
}

}  // namespace pdr::app
