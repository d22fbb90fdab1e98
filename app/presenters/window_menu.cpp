#include "app/presenters/window_menu.h"

#include <QCoreApplication>

#include "render/slice/window_presets.h"
#include "ui/text/language.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Slices)
};

QString titleOf(const WindowPreset& preset) {
    const std::pair<const char*, QString> titles[] = {{"soft tissue", Texts::tr("Soft tissue")},
                                                      {"abdomen", Texts::tr("Abdomen")},
                                                      {"brain", Texts::tr("Brain")},
                                                      {"bone", Texts::tr("Bone")},
                                                      {"hard bone", Texts::tr("Hard bone")},
                                                      {"lung", Texts::tr("Lung")},
                                                      {"vessels", Texts::tr("Vessels")},
                                                      {"mediastinum", Texts::tr("Mediastinum")},
                                                      {"temporal bone", Texts::tr("Temporal bone")}};
    for (const auto& [name, title] : titles)
        if (qstrcmp(name, preset.name) == 0)
            return title;
    return QString::fromLatin1(preset.name);
}

constexpr const char* kPreset = "windowPreset";
constexpr const char* kNoPresets = "noWindowPresets";

}  // namespace

QString whyNoPresets() {
    return Texts::tr("The values of this scan are no HU: windows for tissues are not offered.");
}

void offerPresets(const QMenu& menu, bool offered) {
    for (QAction* entry : menu.actions()) {
        if (entry->objectName() == QLatin1String(kPreset))
            entry->setVisible(offered);
        if (entry->objectName() == QLatin1String(kNoPresets))
            entry->setVisible(!offered);
    }
}

void fillWindowMenu(QMenu& menu, const std::function<void(const GreyWindow&)>& choose,
                    const std::function<void(char)>& chooseKey) {
    for (const WindowPreset& preset : windowPresets()) {
        const QString range =
            QString("%1 / %2").arg(ui::number(preset.window.centre, 0), ui::number(preset.window.width, 0));
        QAction* entry = menu.addAction(QString("&%1  %2\t%3").arg(QChar(preset.key)).arg(titleOf(preset), range));
        entry->setObjectName(kPreset);
        QObject::connect(entry, &QAction::triggered, &menu, [choose, window = preset.window] { choose(window); });
    }
    QAction* why = menu.addAction(whyNoPresets());
    why->setObjectName(kNoPresets);
    why->setEnabled(false);
    why->setVisible(false);
    menu.addSeparator();
    for (const auto& [key, title] :
         {std::pair('9', Texts::tr("As the scan states")), std::pair('0', Texts::tr("Whole range"))}) {
        QAction* entry = menu.addAction(QString("&%1  %2").arg(QChar(key)).arg(title));
        QObject::connect(entry, &QAction::triggered, &menu, [chooseKey, key = key] { chooseKey(key); });
    }
}

}  // namespace pdr::app
