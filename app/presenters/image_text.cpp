#include "app/presenters/image_text.h"

#include <QDate>
#include <QRegularExpression>

#include "app/presenters/look_text.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/room_text.h"
#include "ui/text/status_text.h"

namespace pdr::app {

QStringList denoisedTexts(const Frame& frame) {
    return frame.denoised ? ui::denoisedTexts(frame.denoisedError, frame.lostLines.size()) : QStringList();
}

QStringList remarksOn(const Frame& frame, QSize view) {
    QStringList remarks{ui::comparisonText(frame.schedule, frame.estimator)};
    if (frame.region)
        remarks << ui::boxText(frame.region->status, !frame.region->reached, shownOf(frame).status);
    if (!frame.coarse)
        remarks << ui::unseenText(frame.status);
    remarks << denoisedTexts(frame);
    if (frame.denoised && frame.denoisedError)
        remarks << ui::hiddenDetailTexts(*frame.denoisedError);
    remarks << ui::stretchedText(frame.size, view);
    const std::vector<Bias> known = biases(frame.bias);
    for (const Bias& bias : known)
        if (bias.cause != BiasCause::smoothing)  // denoisedTexts() says more
            remarks << ui::inWords(bias.text);
    if (noneOfComputing(known))
        remarks << ui::MainWindow::tr("No known systematic error");
    remarks.removeAll({});
    return remarks;
}

QString fileNameOf(const FittedLooks& looks, const Frame& frame) {
    static const QRegularExpression noLetters("[^\\w]+", QRegularExpression::UseUnicodePropertiesOption);
    QString look = nameText(looks, frame.lookName).replace(noLetters, "-");
    while (look.endsWith('-'))
        look.chop(1);
    const QString side = QString::fromStdString(orientationLetters(-frame.camera.forward()));
    return QStringList{look, side, QDate::currentDate().toString(Qt::ISODate)}.join('_');
}

}  // namespace pdr::app
