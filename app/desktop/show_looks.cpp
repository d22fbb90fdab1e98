#include "app/desktop/show_looks.h"

#include <algorithm>

#include "app/desktop/look_text.h"

namespace pdr::app {
namespace {

QString groupText(LookGroup group) {
    switch (group) {
        case LookGroup::head:
            return ui::LookGallery::tr("Head");
        case LookGroup::chest:
            return ui::LookGallery::tr("Chest");
        case LookGroup::abdomen:
            return ui::LookGallery::tr("Abdomen");
        case LookGroup::vessels:
            return ui::LookGallery::tr("Vessels");
        case LookGroup::bones:
            return ui::LookGallery::tr("Bones");
        case LookGroup::lungs:
            return ui::LookGallery::tr("Lungs");
        case LookGroup::skin:
            return ui::LookGallery::tr("Skin (identifies the patient)");
        case LookGroup::xray:
            return ui::LookGallery::tr("X-ray");
        case LookGroup::mip:
            return ui::LookGallery::tr("MIP");
        case LookGroup::implants:
            return ui::LookGallery::tr("Implants");
        case LookGroup::own:
            break;
    }
    return ui::LookGallery::tr("My looks");
}

/// Returns the gallery's cards, in the document's order.
QList<ui::LookCard> cardsOf(const Document& document) {
    QList<ui::LookCard> cards;
    for (int i = 0; document.looks().holds(i); ++i) {
        const NamedLook& look = document.looks()[i];
        cards << ui::LookCard{nameText(look), groupText(look.group), doesNotShowText(look),
                              unsuitedText(document.looks().whyUnsuited(i)), look.group == LookGroup::own};
    }
    return cards;
}

/// Returns the image tasks: first the look that is shown, since its brightness is awaited; then those that suit the
/// scan.
std::vector<LookTask> tasksOf(const Document& document) {
    std::vector<LookTask> tasks;
    const auto rank = [&](int look) {
        return look == document.look() ? 0 : document.looks().whyUnsuited(look).empty() ? 1 : 2;
    };
    for (int i = 0; document.looks().holds(i); ++i) {
        tasks.push_back({i, document.setupWith(i)});
        tasks.back().setup.stops = 0;  // the small image finds the brightness
    }
    std::ranges::stable_sort(tasks, {}, [&](const LookTask& task) { return rank(task.look); });
    return tasks;
}

}  // namespace

void showLooks(const DesktopParts& parts) {
    parts.window.look().gallery().setLooks(cardsOf(parts.document));
}

void orderLookPictures(const DesktopParts& parts, bool moving) {
    const Document& document = parts.document;
    if (moving)
        parts.looks.cancel();
    else if (document.hasVolume())
        parts.looks.make(document.seen(), document.parts(), document.bodyBox(), tasksOf(document));
}

void showLookPicture(const DesktopParts& parts, int look, const QImage& picture, double stops) {
    parts.window.look().gallery().setPicture(look, picture);
    parts.document.suggestBrightness(look, stops);
}

}  // namespace pdr::app
