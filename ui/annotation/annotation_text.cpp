#include "ui/annotation/annotation_text.h"

#include <QCoreApplication>

#include "ui/text/cut_text.h"

namespace pdr::ui {

QString lookText(const QString& look, bool maskAwaited) {
    return maskAwaited ? QCoreApplication::translate("Annotations", "%1 (the rest is not yet removed)").arg(look)
                       : look;
}

QStringList annotationTexts(const ImageFacts& facts) {
    QStringList texts{lookText(facts.look, facts.maskAwaited), facts.notShown, cutText(facts.clip, facts.uncut),
                      facts.ctDenoised ? QCoreApplication::translate("Annotations", "CT denoised") : QString()};
    texts.removeAll({});
    return texts;
}

}  // namespace pdr::ui
