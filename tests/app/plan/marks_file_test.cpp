/// Measurements as files of other programs: as they were written before (golden), and read back by another reader. With
/// PDR_GOLDEN_OUT, a folder, the files of this program are written there.

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <locale>

#include "app/plan/marks_csv.h"
#include "app/plan/marks_file.h"
#include "app/plan/marks_slicer.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/places.h"
#include "tests/support/some_marks.h"

namespace pdr::app {
namespace {

const std::vector<MarkRow> kRows = marksTable(test::someMarks(), test::scanOfMarks());

/// Decimal commas, and dots between thousands.
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// Reads a file of RFC 4180 by its grammar, letter by letter.
std::vector<QStringList> recordsOf(const std::string& text) {
    std::vector<QStringList> records;
    std::string field;
    QStringList record;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (quoted && letter == '"' && at + 1 < text.size() && text[at + 1] == '"')
            field += text[++at];
        else if (letter == '"')
            quoted = !quoted;
        else if (quoted || (letter != ',' && letter != '\r' && letter != '\n'))
            field += letter;
        else if (letter == ',' || letter == '\n') {
            record << QString::fromStdString(std::exchange(field, {}));
            if (letter == '\n')
                records.push_back(std::exchange(record, {}));
        }
    }
    return records;
}

QByteArray golden(const char* name) {
    QFile file(QStringLiteral(PDR_SOURCE_DIR "/tests/app/plan/golden/") + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeGolden(const QString& name, const std::string& text) {
    const QString folder = qEnvironmentVariable("PDR_GOLDEN_OUT");
    QFile file(folder + "/" + name);
    if (!folder.isEmpty() && file.open(QIODevice::WriteOnly))
        file.write(text.data(), qint64(text.size()));
}

}  // namespace

class MarksFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path at(const QString& name) const { return folder_.filePath(name).toStdString(); }

  private slots:
    void initTestCase() {
        writeGolden("marks.csv", marksCsv(kRows));
        writeGolden("marks.mrk.json", marksForSlicer(kRows));
    }

    void theFilesAreThoseOfEarlierPrograms() {
        QCOMPARE(QByteArray::fromStdString(marksCsv(kRows)), golden("marks.csv"));
        QCOMPARE(QByteArray::fromStdString(marksForSlicer(kRows)), golden("marks.mrk.json"));
    }

    void everyCellOfTheCsvComesBack() {
        const std::vector<QStringList> records = recordsOf(marksCsv(kRows));
        QCOMPARE(records.size(), kRows.size() + 1);
        const auto column = [&](const QString& name) {
            const qsizetype index = records[0].indexOf(name);
            return index < 0 ? (qFatal("no column %s", qPrintable(name)), 0) : index;
        };
        for (std::size_t n = 0; n < kRows.size(); ++n) {
            const QStringList& record = records[n + 1];
            const MarkRow& row = kRows[n];
            QCOMPARE(record.size(), records[0].size());
            QCOMPARE(record[column("id")].toULongLong(), row.id);
            QString name = record[column("name")];
            QCOMPARE((name.startsWith('\'') ? name.mid(1) : name).toStdString(), row.name);
            QCOMPARE(record[column("text")].toStdString(), readable(row));
            const QString value = record[column("value")], plusMinus = record[column("plus_minus_95")];
            QCOMPARE(value.isEmpty(), !row.value);
            QCOMPARE(plusMinus.isEmpty(), !row.value || !row.value->plusMinus);
            if (!value.isEmpty())
                QVERIFY(std::abs(value.toDouble() - row.value->value) <= 0.5001e-4);
            if (!plusMinus.isEmpty())
                QVERIFY(std::abs(plusMinus.toDouble() - *row.value->plusMinus) <= 0.5001e-4);
            const bool isRegion = row.value && row.value->region;
            QCOMPARE(record[column("voxels")], isRegion ? QString::number(row.value->region->count) : "");
            QCOMPARE(record[column("median_hu")].isEmpty(), !isRegion);
            if (isRegion)
                QVERIFY(std::abs(record[column("mean_hu")].toDouble() - row.value->region->meanHu) <= 0.5001e-4);
            QCOMPARE(record[column("value_unit")], isRegion ? "HU" : "");
            for (const char* figure : {"sd", "lowest", "highest", "mean", "median"})
                QCOMPARE(record[column(QString(figure) + "_value")], record[column(QString(figure) + "_hu")]);
            QCOMPARE(record[column("mean_value_plus_minus_95")], record[column("mean_plus_minus_95")]);
            const bool hasArea = row.value && row.value->area;
            QCOMPARE(record[column("area_mm2")].isEmpty(), !hasArea);
            if (hasArea)
                QVERIFY(std::abs(record[column("area_mm2")].toDouble() - row.value->area->value) <= 0.5001e-4);
            const QStringList corners = record[column("corners_mm_lps")].split("; ", Qt::SkipEmptyParts);
            QCOMPARE(std::size_t(corners.size()), row.kind == MeasureKind::polygon ? row.places.size() : 0);
            for (qsizetype corner = 0; corner < corners.size(); ++corner) {
                const QStringList mm = corners[corner].split(' ');
                QVERIFY(glm::length(dvec3(mm[0].toDouble(), mm[1].toDouble(), mm[2].toDouble()) -
                                    row.places[std::size_t(corner)].mm) < 1e-4);
            }
            for (std::size_t place = 0; place < kMostPlaces; ++place) {
                const QString number = QString::number(place + 1);
                const QString x = record[column("x_mm_lps_" + number)];
                QCOMPARE(x.isEmpty(), place >= row.places.size());
                if (place < row.places.size()) {
                    const dvec3 mm(x.toDouble(), record[column("y_mm_lps_" + number)].toDouble(),
                                   record[column("z_mm_lps_" + number)].toDouble());
                    QVERIFY(glm::length(mm - row.places[place].mm) < 1e-4);
                }
            }
        }
    }

    /// Values from 0 to 0.1 in steps of 0.001: columns of HU are empty, and four decimals are not enough.
    void valuesThatAreNoHuHaveColumnsAndDecimals() {
        const Volume scan = test::scanOfMarks();
        const Volume values(scan.geometry(), Voxels(scan.voxels().begin(), scan.voxels().end()), {},
                            unitWord(ValueUnit::other("mm2/s", 0.001, 0)));
        const std::vector<MarkRow> rows = marksTable(test::someMarks(), values);
        const std::vector<QStringList> records = recordsOf(marksCsv(rows));
        const QJsonArray markups =
            QJsonDocument::fromJson(QByteArray::fromStdString(marksForSlicer(rows)))["markups"].toArray();
        const auto cellOf = [&](std::size_t n, const char* name) { return records[n + 1][records[0].indexOf(name)]; };
        constexpr std::size_t kBall = 7;
        const Measured& ball = *rows[kBall].value;
        QCOMPARE(cellOf(kBall, "value_unit"), "mm2/s");
        for (const char* name : {"sd_hu", "lowest_hu", "highest_hu", "mean_hu", "mean_plus_minus_95", "median_hu"})
            QCOMPARE(cellOf(kBall, name), "");
        const std::vector<std::pair<const char*, double>> figures{{"value", ball.value},
                                                                  {"plus_minus_95", *ball.plusMinus},
                                                                  {"sd_value", ball.region->sdHu},
                                                                  {"lowest_value", ball.region->lowestHu},
                                                                  {"highest_value", ball.region->highestHu},
                                                                  {"mean_value", ball.region->meanHu},
                                                                  {"mean_value_plus_minus_95", *ball.plusMinus},
                                                                  {"median_value", ball.region->medianHu}};
        for (const auto& [name, figure] : figures)
            QVERIFY2(std::abs(cellOf(kBall, name).toDouble() - figure) <= 0.5001e-7, name);
        QVERIFY(std::abs(markups[8]["measurements"][0]["value"].toDouble() - ball.value) <= 0.5001e-7);
        QCOMPARE(markups[8]["measurements"][0]["units"].toString(), "mm2/s");
        QCOMPARE(cellOf(0, "value").section('.', 1).size(), 4);  // a length
    }

    void noCellIsAFormula() {
        Plan plan;
        for (const char* name : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "'=1"})
            plan.measurements.push_back(
                {plan.measurements.size(), MeasureKind::distance, name, {measure::typedPlace({}), {}}});
        const std::vector<QStringList> records = recordsOf(marksCsv(marksTable(plan, test::scanOfMarks())));
        QCOMPARE(records.size(), plan.measurements.size() + 1);
        for (std::size_t n = 0; n < plan.measurements.size(); ++n)
            QCOMPARE(records[n + 1][2].toStdString(), "'" + plan.measurements[n].name);
        plan.measurements = {{1, MeasureKind::point, "fat", {measure::typedPlace({})}}};
        const Volume fat(VolumeGeometry::aligned(ivec3(2), dvec3(1), dvec3(0)), Voxels(8, -80));
        QVERIFY(marksCsv(marksTable(plan, fat)).find(",-80.0000,,,HU,'-80 HU,") != std::string::npos);
    }

    void numbersHaveADecimalPointInEveryLanguage() {
        const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
        QLocale::setDefault(QLocale(QLocale::German));
        const std::string csv = marksCsv(kRows), slicer = marksForSlicer(kRows);
        std::locale::global(before);
        QLocale::setDefault(QLocale::c());
        QCOMPARE(QByteArray::fromStdString(csv), golden("marks.csv"));
        QCOMPARE(QByteArray::fromStdString(slicer), golden("marks.mrk.json"));
    }

    /// Slicer turns LPS into its own RAS: +x is left, +y is back. Two lines are two of its lines.
    void slicerGetsPlacesAsTheyAre() {
        const QJsonDocument file = QJsonDocument::fromJson(QByteArray::fromStdString(marksForSlicer(kRows)));
        QVERIFY(file["@schema"].toString().endsWith("markups-schema-v1.0.3.json#"));
        const QJsonArray markups = file["markups"].toArray();
        std::vector<dvec3> positions, expected;
        QStringList types;
        for (const QJsonValue& markup : markups) {
            QCOMPARE(markup["coordinateSystem"].toString(), "LPS");
            QCOMPARE(markup["coordinateUnits"].toString(), "mm");
            types << markup["type"].toString();
            for (const QJsonValue& point : markup["controlPoints"].toArray()) {
                const QJsonValue at = point["position"];
                positions.push_back({at[0].toDouble(), at[1].toDouble(), at[2].toDouble()});
            }
        }
        for (const MarkRow& row : kRows)
            for (const measure::Place& place : row.places)
                if (row.kind != MeasureKind::ellipse)
                    expected.push_back(place.mm);
        const auto around =
            positions.begin() + std::ptrdiff_t(expected.size()) - 7;  // a polygon and a ball are behind it
        for (auto at = around; at != positions.end() - 7; ++at)
            QVERIFY(std::abs(at->x * at->x / 81 + at->y * at->y / 36 - 1) < 1e-9 && at->z == 4);
        QVERIFY(*around == dvec3(9, 0, 4));
        positions.erase(around, positions.end() - 7);
        QVERIFY(positions == expected);
        QCOMPARE(types.join(' '),
                 "Line Line Line Angle Angle Line Line Fiducial Fiducial ClosedCurve ClosedCurve Fiducial");
        QCOMPARE(markups[0]["name"].toString(), "Distance 1");
        QCOMPARE(markups[6]["name"].toString(), "Two lines 1 (2)");
    }

    /// Only an estimate has a ±, and a bound never looks like an estimate.
    void slicerGetsValuesWithTheirPlusMinus() {
        const QJsonArray markups =
            QJsonDocument::fromJson(QByteArray::fromStdString(marksForSlicer(kRows)))["markups"].toArray();
        const auto names = [&](qsizetype markup) {
            QStringList list;
            for (const QJsonValue& measurement : markups[markup]["measurements"].toArray())
                list << measurement["name"].toString();
            return list.join("; ");
        };
        QCOMPARE(names(0), "PD-Render distance; PD-Render distance, plus or minus");
        QCOMPARE(names(1), "PD-Render distance, at most");
        QCOMPARE(names(2), "PD-Render distance");
        QCOMPARE(names(3), "PD-Render angle, at least");
        QCOMPARE(names(4), "");
        QCOMPARE(names(5), "PD-Render angle of two lines; PD-Render angle of two lines, plus or minus");
        QCOMPARE(names(6), "");
        QCOMPARE(names(7), "PD-Render HU");
        QCOMPARE(names(8), "PD-Render mean HU; PD-Render mean HU, plus or minus");
        const QJsonValue first = markups[0]["measurements"];
        QVERIFY(std::abs(first[0]["value"].toDouble() - kRows[0].value->value) < 1e-4);
        QCOMPARE(first[0]["description"].toString().toStdString(), readable(kRows[0]));
        QCOMPARE(first[0]["units"].toString(), "mm");
        QVERIFY(std::abs(first[1]["value"].toDouble() - *kRows[0].value->plusMinus) < 1e-4);
    }

    void aFileIsTheOwnersAndWholeOrNotThere() {
        for (const char* name : {"a.csv", "a.mrk.json", "B.CSV", "B.MRK.JSON"}) {
            QVERIFY(writeMarks(kRows, at(name)));
            const auto rights = QFile::permissions(folder_.filePath(name));
            QVERIFY(!(rights & (QFile::ReadGroup | QFile::ReadOther)));
        }
        QFile csv(folder_.filePath("B.CSV"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll(), golden("marks.csv"));
        {
            const test::FileSizeLimit full(100);
            const auto written = writeMarks(kRows, at("a.csv"));
            QVERIFY(!written && !written.error().what.empty());
        }
        QFile before(folder_.filePath("a.csv"));
        QVERIFY(before.open(QIODevice::ReadOnly));
        QCOMPARE(before.readAll(), golden("marks.csv"));
        QVERIFY(!writeMarks(kRows, at("no/such/place.csv")));
        QCOMPARE(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden).size(), 4);
    }

    void otherEndingsAndEmptyTablesAreRefused() {
        for (const char* name : {"a.json", "a.mrk", "a.txt", "a", ".mrk.json.gz"}) {
            const auto written = writeMarks(kRows, at(name));
            QVERIFY(!written && written.error().kind == ErrorKind::refused && !isMarksFile(at(name)));
        }
        QVERIFY(!writeMarks({}, at("empty.csv")));
        QVERIFY(!QFile::exists(folder_.filePath("empty.csv")));
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::MarksFileTest)
#include "marks_file_test.moc"
