#include "ui/text/series_text.h"

#include <QCoreApplication>
#include <QDate>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "render/volume/sheared.h"
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

/// Returns whether the description is the name of the series' file, as that of a volume file is.
bool isFileName(const dicom::Series& series) {
    return !series.slices.empty() && series.slices.front().file.filename() == series.series.description;
}

/// Returns the modality as clinicians write it; empty: it is CT, which needs no word, or none that DICOM knows.
QString otherModality(const dicom::Series& series) {
    static const QRegularExpression code("^[A-Z]{2,5}$");
    const QString modality = QString::fromStdString(series.series.modality);
    if (modality == "CT" || !code.match(modality).hasMatch())
        return {};
    return modality == "PT" ? QString("PET") : modality;
}

}  // namespace

QString seriesName(const dicom::Series& series) {
    QString title = QString::fromStdString(series.series.description).trimmed();
    if (title.isEmpty())
        title = QString::fromStdString(series.study.description).trimmed();
    if (title.isEmpty())
        title = translated("Series %1").arg(series.series.number);
    return title;
}

QString seriesTitle(const dicom::Series& series) {
    return joined({seriesName(series), inWords(series.series.phase)});
}

QString seriesNumber(const dicom::Series& series) {
    const QString other = otherModality(series);
    return other.isEmpty() ? translated("CT series %1").arg(series.series.number)
                           : translated("%1 series %2").arg(other).arg(series.series.number);
}

QString windowSubject(const dicom::Series& series) {
    const bool described = !series.series.description.empty() || !series.study.description.empty();
    const QString title = seriesTitle(series);
    return described && !namesPatient(title, series.patient) && !isFileName(series) ? title : seriesNumber(series);
}

QStringList seriesFacts(const dicom::Series& series) {
    const bool loadable = series.verdict.loadable();
    const ivec3 size = series.geometry.size;
    const auto images = series.slices.size();
    const QString count = loadable      ? translated("%1 slices").arg(size.z)
                          : images == 1 ? translated("1 image")
                                        : translated("%1 images").arg(images);
    const QString apart = loadable ? number(sliceDrift(series.geometry).gapMm, 2) + " mm" : QString();
    const QString pixels = size.x > 0 ? QString::fromUtf8("%1 × %2").arg(size.x).arg(size.y) : QString();
    QStringList lines{joined({otherModality(series), count, apart}), inWords(series.series.phase),
                      joined({pixels, inWords(series.series.coding)})};
    lines.removeAll({});
    return lines;
}

QString studyText(const dicom::Series& series, bool namesHidden) {
    const QString date = dateText(series.study.date.empty() ? series.series.date : series.study.date);
    const QString description = QString::fromStdString(series.study.description).trimmed();
    return joined({date, namesHidden ? QString() : description});
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
