#include "app/presenters/effect_cost_rows.h"

#include <algorithm>
#include <cmath>

#include "render/accuracy/effect_cost_text.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

QString tr(const char* text) {
    return ui::EffectCosts::tr(text);
}

QString qt(const std::string& text) {
    return QString::fromStdString(text);
}

/// Returns a phrase: "light from all around (the image changes by 0.02 levels on average, 95 % of it by less than
/// 0.31; any target takes 97 % of the time)".
QString phraseOf(const TriedEffect& row) {
    const EffectTrial& trial = *row.trial;
    QString phrase = tr("%1 (the image changes by %2 levels on average, 95 % of it by less than %3")
                         .arg(ui::inWords(row.effect.name))
                         .arg(ui::number(trial.change.mean.value, 2), ui::number(trial.change.ninetyFifth.high, 2));
    if (trial.time)
        phrase += tr("; any target takes %1 of the time").arg(ui::inWords(timeLeftText(*trial.time)));
    return phrase + ')';
}

ui::EffectRow rowOf(const TriedEffect& tried, bool complete) {
    ui::EffectRow row;
    row.name = ui::inWords(tried.effect.name);
    row.reason = ui::inWords(tried.effect.reason);
    row.ofViewBefore = tried.ofViewBefore;
    if (!tried.trial) {
        const bool waits = tried.canBeTried() && !complete;
        row.milliseconds = waits ? QString::fromUtf8("…") : QString::fromUtf8("–");
        return row;
    }
    row.milliseconds = ui::inWords(costText(tried.trial->milliseconds));
    row.share = ui::inWords(shareText(tried.trial->share));
    row.meanLevels = ui::inWords(levelsText(tried.trial->change.mean));
    row.levels95 = ui::inWords(levelsText(tried.trial->change.ninetyFifth));
    row.time = tried.trial->time ? ui::inWords(timeLeftText(*tried.trial->time)) : tr("not known");
    return row;
}

QString howText(const EffectCosts& effectCosts) {
    if (!effectCosts.failure.empty())
        return tr("Not measured any further: %1").arg(ui::inWords(effectCosts.failure));
    const QString where = tr("on an image of %1 × %2 pixels on the CPU (%3)")
                              .arg(effectCosts.film.x)
                              .arg(effectCosts.film.y)
                              .arg(qt(effectCosts.device.details));
    const QString text = effectCosts.complete
                             ? tr("Measured %1, %2 s of calibration").arg(where, ui::number(effectCosts.seconds, 1))
                         : effectCosts.film.x > 0 ? tr("Measuring %1 from time to time, in 1/20 of the time").arg(where)
                                                  : tr("Measuring begins when the image is at rest");
    const bool before = std::ranges::any_of(effectCosts.effects, &TriedEffect::ofViewBefore);
    return before ? text + tr(" · italics: measured for the previous view") : text;
}

}  // namespace

LeanSetup leanSetup(const Document& document, const EffectCosts& effectCosts) {
    LeanSetup lean{document.setup(), {}};
    Scene scene = document.scene();
    for (const TriedEffect& row : effectCosts.effects) {
        if (row.ofViewBefore || !row.couldBeLeftOut())
            continue;
        Scene without = scene;
        row.effect.leaveOut(without);
        if (auto setup = setupOf(without, lean.setup)) {
            lean.setup = *std::move(setup);
            lean.leftOut << phraseOf(row);
            scene = std::move(without);
        }
    }
    return lean;
}

ui::EffectRows effectRows(const EffectCosts& effectCosts, const QStringList& leftOut) {
    ui::EffectRows rows;
    if (effectCosts.effects.empty())
        return rows;
    for (const TriedEffect& tried : effectCosts.effects)
        if (tried.effect.needed || tried.canBeTried())
            rows.needed << rowOf(tried, effectCosts.complete);
        else
            rows.off << ui::inWords(tried.effect.name) + ": " + ui::inWords(tried.effect.reason);
    rows.how = howText(effectCosts);
    rows.leftOut = leftOut;
    rows.complete = effectCosts.complete;
    return rows;
}

}  // namespace pdr::app
