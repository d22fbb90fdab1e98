#include "app/presenters/look_cards.h"

#include <algorithm>

#include "app/presenters/look_text.h"

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

}  // namespace

QList<ui::LookCard> lookCards(const Document& document) {
    QList<ui::LookCard> cards;
    for (int i = 0; document.looks().holds(i); ++i) {
        const NamedLook& look = document.looks()[i];
        const QString group =
            document.looks().areInHu() ? groupText(look.group) : ui::LookGallery::tr("Values that are no HU");
        cards << ui::LookCard{nameText(look), group, doesNotShowText(look),
                              unsuitedText(document.looks().whyUnsuited(i)), look.group == LookGroup::own};
    }
    return cards;
}

std::vector<LookTask> lookTasks(const Document& document) {
    std::vector<LookTask> tasks;
    const auto rank = [&](int look) {
        return look == document.look() ? 0 : document.looks().whyUnsuited(look).empty() ? 1 : 2;
    };
    for (int i = 0; document.looks().holds(i); ++i) {
        LookTask task{i, document.setupWith(i), {}};
        task.setup.stops = 0;  // the small image finds the brightness
        if (document.scanParts() && !task.setup.look.parts.empty())
            task.parts = document.scanParts()->map;
        tasks.push_back(std::move(task));
    }
    std::ranges::stable_sort(tasks, {}, [&](const LookTask& task) { return rank(task.look); });
    return tasks;
}

}  // namespace pdr::app
