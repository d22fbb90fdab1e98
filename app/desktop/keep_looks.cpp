#include "app/desktop/keep_looks.h"

#include <algorithm>

#include "app/desktop/look_text.h"
#include "app/desktop/show_looks.h"
#include "app/desktop/show_message.h"
#include "app/looks/look_files.h"
#include "render/scene/sky_picture.h"

namespace pdr::app {
namespace {

/// Returns the look that is shown, with its brightness, under `name`.
NamedLook shownLook(const Document& document, const std::string& name) {
    const PictureSetup& setup = document.setup();
    NamedLook named;
    if (const NamedLook* begun = document.looks().beginningOf(setup)) {
        named.doesNotShow = begun->doesNotShow;
        named.bloodHu = begun->bloodHu;
        named.cut = begun->cut;
    }
    named.name = name;
    named.model = setup.model;
    named.look = setup.look;
    named.look.display.exposure = displayOf(setup).exposure;
    named.look.environment = withoutPicture(named.look.environment);  // look files contain no environment images
    return named;
}

/// Returns the looks that are bundled with the program.
std::vector<NamedLook> carriedLooks(const Document& document) {
    std::vector<NamedLook> looks = document.looks().drawn();
    std::erase_if(looks, [](const NamedLook& look) { return look.group == LookGroup::own; });
    return looks;
}

Result<void> checkFree(const Document& document, const std::string& name) {
    for (const NamedLook& look : carriedLooks(document))
        if (look.name == name || nameText(look).toStdString() == name)
            return Error{phrase("a built-in look has this name"), name, phrase("Choose another one.")};
    return {};
}

/// Shows the looks after a change, or its error, and chooses the look `name` if it exists.
void showChange(const DesktopParts& parts, const Result<void>& changed, const std::string& name) {
    if (!changed)
        return showFailure(parts, changed.error());
    offerOwnLooks(parts);
    const auto& looks = parts.document.looks().fitted();
    if (const auto look = std::ranges::find(looks, name, &NamedLook::name); look != looks.end())
        parts.document.chooseLook(int(look - looks.begin()));
}

void keep(const DesktopParts& parts, const NamedLook& look) {
    const Result<void> free = checkFree(parts.document, look.name);
    showChange(parts, free ? parts.ownLooks.save(look) : free, look.name);
}

}  // namespace

void offerOwnLooks(const DesktopParts& parts) {
    std::vector<NamedLook> looks = carriedLooks(parts.document);
    OwnLooks::Read own = parts.ownLooks.read();
    for (const Error& problem : own.problems)
        showFailure(parts, problem);
    for (NamedLook& look : own.looks)
        looks.push_back(std::move(look));
    parts.document.setLooks(std::move(looks));
    orderLookPictures(parts, false);
}

void saveLook(const DesktopParts& parts, const QString& name) {
    const bool sky = parts.document.setup().look.environment.image != nullptr;
    keep(parts, shownLook(parts.document, name.toStdString()));
    if (sky)
        showNotice(parts,
                   ui::MainWindow::tr("Looks cannot hold an environment image: this one has uniform ambient light."));
}

void renameLook(const DesktopParts& parts, const QString& from, const QString& to) {
    const Result<void> free = checkFree(parts.document, to.toStdString());
    showChange(parts, free ? parts.ownLooks.rename(from.toStdString(), to.toStdString()) : free, to.toStdString());
}

void deleteLook(const DesktopParts& parts, const QString& name) {
    showChange(parts, parts.ownLooks.remove(name.toStdString()), "");
}

void importLook(const DesktopParts& parts, const QString& file) {
    const auto look = readLookFile(file, parts.document.looks()[0]);
    if (!look)
        return showFailure(parts, look.error());
    keep(parts, *look);
}

void exportLook(const DesktopParts& parts, const QString& file) {
    const NamedLook look = shownLook(parts.document, lookTitle(parts.document.setup()));
    if (auto written = writeLookFile(look, file); !written)
        return showFailure(parts, written.error());
    showSaved(parts, file);
}

}  // namespace pdr::app
