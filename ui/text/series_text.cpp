#include "ui/text/series_text.h"

#include <QCoreApplication>
#include <QDate>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("series", text);
}

/// Returns DICOM's "20240131" as "2024-01-31"; anything else unchanged.
QString dateText(const std::string& dicomDate) {
    const QString text = QString::fromStdString(dicomDate).trimmed();
    const QDate date = QDate::fromString(text, "yyyyMMdd");
    return date.isValid() ? date.toString(Qt::ISODate) : text;
}

const char* stackWord(dicom::Stack stack) {
    using dicom::Stack;
    switch (stack) {
        case Stack::even:
            return QT_TRANSLATE_NOOP("series", "can be shown");
        case Stack::singleSlice:
            return QT_TRANSLATE_NOOP("series", "a single slice");
        case Stack::gap:
            return QT_TRANSLATE_NOOP("series", "a slice is missing");
        case Stack::doubled:
            return QT_TRANSLATE_NOOP("series", "duplicate slice position");
        case Stack::tilted:
            return QT_TRANSLATE_NOOP("series", "gantry tilt");
        case Stack::mixedOrientation:
            return QT_TRANSLATE_NOOP("series", "mixed slice orientations");
        case Stack::mixedSize:
            return QT_TRANSLATE_NOOP("series", "slices of different size");
        case Stack::noGeometry:
            return QT_TRANSLATE_NOOP("series", "missing position data");
        case Stack::notCt:
            return QT_TRANSLATE_NOOP("series", "not a CT volume");
        case Stack::unreadable:
            return QT_TRANSLATE_NOOP("series", "cannot be read");
    }
    return "";
}

/// Joins the parts that are not empty.
QString joined(QStringList parts) {
    parts.removeAll({});
    return parts.join(QString::fromUtf8(" · "));
}

/// Returns whether `text` contains a part of the patient's name or the ID: descriptions sometimes contain names.
bool namesPatient(const QString& text, const dicom::PatientFacts& patient) {
    constexpr int kShortest = 3;  // shorter parts occur in any text
    static const QRegularExpression between("[\\^=,\\s]+");
    const QStringList parts = QString::fromStdString(patient.name).split(between)
                              << QString::fromStdString(patient.id).trimmed();
    return std::ranges::any_of(parts, [&](const QString& part) {
        return part.size() >= kShortest && text.contains(part, Qt::CaseInsensitive);
    });
}

}  // namespace

QString seriesTitle(const dicom::Series& series) {
    QString title = QString::fromStdString(series.series.description).trimmed();
    if (title.isEmpty())
        title = QString::fromStdString(series.study.description).trimmed();
    if (title.isEmpty())
        title = translated("Series %1").arg(series.series.number);
    return series.series.phase.empty() ? title : joined({title, inWords(series.series.phase)});
}

QString seriesNumber(const dicom::Series& series) {
    return translated("CT series %1").arg(series.series.number);
}

QString windowSubject(const dicom::Series& series) {
    const bool described = !series.series.description.empty() || !series.study.description.empty();
    const QString title = seriesTitle(series);
    return described && !namesPatient(title, series.patient) ? title : seriesNumber(series);
}

QString seriesFacts(const dicom::Series& series) {
    const QChar times(0x00D7);
    const ivec3 size = series.geometry.size;
    QStringList parts;
    if (size.x > 0 && size.y > 0)
        parts << QString("%1 %4 %2 %4 %3").arg(size.x).arg(size.y).arg(std::max(size.z, 1)).arg(times);
    if (series.verdict.loadable()) {
        const dvec3 mm = series.geometry.spacingMm();
        parts << QString("%1 %4 %2 %4 %3 mm").arg(number(mm.x, 2), number(mm.y, 2), number(mm.z, 2)).arg(times);
    }
    return parts.join(", ");
}

QString seriesDate(const dicom::Series& series) {
    return dateText(series.series.date.empty() ? series.study.date : series.series.date);
}

QString verdictText(const dicom::GeometryVerdict& verdict) {
    const QChar symbol(verdict.loadable() ? 0x2713 : 0x2717);
    return QString("%1  %2").arg(symbol).arg(translated(stackWord(verdict.stack)));
}

QString patientName(const dicom::PatientFacts& patient) {
    const QString first = QString::fromStdString(patient.name).section('=', 0, 0);
    QStringList parts = first.split('^', Qt::SkipEmptyParts);
    if (parts.isEmpty())
        return translated("Name not given");
    const QString family = parts.takeFirst().trimmed();
    return parts.isEmpty() ? family : family + ", " + parts.join(' ').simplified();
}

QString patientDetails(const dicom::PatientFacts& patient) {
    const QString born = dateText(patient.birthDate), id = QString::fromStdString(patient.id).trimmed();
    return joined({born.isEmpty() ? QString() : translated("born %1").arg(born),
                   id.isEmpty() ? QString() : translated("ID %1").arg(id)});
}

QStringList patientLines(const dicom::Series& series) {
    const QString date = dateText(series.study.date.empty() ? series.series.date : series.study.date);
    QStringList lines{patientName(series.patient), patientDetails(series.patient), joined({date, seriesTitle(series)})};
    lines.removeAll({});
    return lines;
}

}  // namespace pdr::ui
