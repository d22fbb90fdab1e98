#include "app/changed_look.h"

#include <QCoreApplication>

namespace pdr::app {
namespace {

std::string suffix() {
    return QCoreApplication::translate("ChangedLook", " (changed)").toStdString();
}

}  // namespace

std::string changedName(const std::string& name) {
    return unchangedName(name) + suffix();
}

std::string unchangedName(const std::string& name) {
    const std::string changed = suffix();
    return name.ends_with(changed) ? name.substr(0, name.size() - changed.size()) : name;
}

}  // namespace pdr::app
