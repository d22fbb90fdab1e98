/// Looks of 3D Slicer: reading, writing, and error texts.

#include <QTest>

#include <algorithm>

#include "render/scene/slicer/vp_json.h"
#include "render/scene/slicer/vp_text.h"

using namespace pdr;
using namespace pdr::slicer;

namespace {

/// The example of 3D Slicer's developer guide.
const std::string kText =
    "1\n1\n0.9\n0.1\n0.2\n10\n"
    "14 -3024 0 -86.9767 0 45.3791 0.169643 139.919 0.589286 347.907 0.607143 1224.16 0.607143 3071 0.616071\n"
    "4 0 1 255 1\n"
    "28 -3024 0 0 0 -86.9767 0 0.25098 1 45.3791 1 0 0 139.919 1 0.894893 0.894893 347.907 1 1 0.25098 1224.16 1 1 1 "
    "3071 0.827451 0.658824 1\n";

/// Returns the text with quotation marks instead of apostrophes.
std::string quoted(std::string text) {
    std::ranges::replace(text, '\'', '"');
    return text;
}

const std::string kJson = quoted(
    "{ "
    "'@schema': 'https://raw.githubusercontent.com/slicer/slicer/main/some-schema.json#', "
    "'volumeProperties': [{ 'effectiveRange': [0, 220], 'isoSurfaceValues': [], 'scatteringAnisotropy': 0.3, "
    "'components': [{ 'shade': true, 'scalarOpacityUnitDistance': 2, "
    "'lighting': { 'diffuse': 1.0, 'ambient': 0.2, 'specular': 0.1, 'specularPower': 1.0 }, "
    "'scalarOpacity': { 'type': 'piecewiseLinearFunction', 'points': [ "
    "{ 'x': 0, 'y': 0, 'midpoint': 0.5, 'sharpness': 0 }, { 'x': 220, 'y': 0.5, 'midpoint': 0.5, 'sharpness': 0 }] }, "
    "'rgbTransferFunction': { 'type': 'colorTransferFunction', 'points': [ "
    "{ 'x': 0, 'color': [0, 0, 0], 'midpoint': 0.5, 'sharpness': 0 }, "
    "{ 'x': 220, 'color': [1, 0.5, 0.25], 'midpoint': 0.5, 'sharpness': 0 }] } }] }] } ");

std::string replaced(std::string text, const std::string& before, const std::string& after) {
    const std::size_t at = text.find(before);
    return at == std::string::npos ? "nothing was replaced" : text.replace(at, before.size(), after);
}

NamedLook base() {
    NamedLook look;
    look.name = "base";
    look.look.transferFunction.nodes = {{0, 0}};
    look.look.rig.follows = LightRig::Follows::patient;
    look.look.display.exposure = 3;
    return look;
}

/// Returns the light that passes a millimetre at `hu`.
double transmittance(const NamedLook& look, float hu) {
    const TransferFunction& function = look.look.transferFunction;
    return std::exp(-double(function.extinctionPerMm) * double(function.at(hu).opacity));
}

}  // namespace

class SlicerTest : public QObject {
    Q_OBJECT

  private slots:
    void theExampleOfTheGuideIsRead() {
        const auto property = propertyFromText(kText, "guide.vp");
        QVERIFY2(property, property ? "" : property.error().text().c_str());
        QCOMPARE(property->opacity.size(), std::size_t(7));
        QCOMPARE(property->colours.size(), std::size_t(7));
        QVERIFY(property->shade && !property->simplified && property->specularPower == 10);
        const auto look = lookOf(*property, "guide", base());
        QVERIFY2(look, look ? "" : look.error().text().c_str());
        for (const CurvePoint& point : property->opacity)  // an opacity of 1 mm
            QVERIFY(std::abs(transmittance(*look, point.hu) - (1 - double(point.value))) < 1e-5);
        for (const float hu : {60.0f, 90.0f, 120.0f})  // and between the points
            QVERIFY(std::abs(transmittance(*look, hu) - (1 - double(valueAt(property->opacity, hu)))) < 0.02);
        QVERIFY(look->look.transferFunction.at(45.3791f).albedo == vec3(1, 0, 0));
        QVERIFY(look->look.rig == base().look.rig && look->look.display == base().look.display);
        QVERIFY(look->group == LookGroup::own && look->doesNotShow.empty());
    }

    void screenColoursBecomeLinear() {
        const auto property = propertyFromJson(kJson, "a.vp.json");
        QVERIFY2(property, property ? "" : property.error().text().c_str());
        const auto look = lookOf(*property, "a", base());
        const vec3 albedo = look->look.transferFunction.at(220).albedo;
        QVERIFY(albedo.x == 1 && std::abs(albedo.y - 0.21404f) < 1e-4f && std::abs(albedo.z - 0.05088f) < 1e-4f);
        QVERIFY(std::abs(transmittance(*look, 220) - std::sqrt(0.5)) < 1e-5);  // of 2 mm
        QCOMPARE(look->look.phaseG, 0.3f);
    }

    void whatIsWrittenIsReadAgain() {
        for (const bool asText : {true, false}) {
            VolumeProperty property = *propertyFromText(kText, "");
            const auto again = asText ? propertyFromText(textOf(property), "") : propertyFromJson(jsonOf(property), "");
            QVERIFY2(again, again ? "" : again.error().text().c_str());
            QVERIFY(again->opacity == property.opacity && again->colours == property.colours);
            QVERIFY(again->shade == property.shade && again->specularPower == property.specularPower);
        }
    }

    void aLookSurvivesTheWayThroughSlicer() {
        NamedLook look = *lookOf(*propertyFromText(kText, ""), "x", base());
        const NamedLook again = *lookOf(*propertyFromJson(jsonOf(propertyOf(look)), ""), "x", base());
        for (const float hu : {-500.0f, 0.0f, 45.3791f, 100.0f, 139.919f, 700.0f, 3000.0f}) {
            QVERIFY(std::abs(transmittance(look, hu) - transmittance(again, hu)) < 1e-3);
            QVERIFY(glm::distance(look.look.transferFunction.at(hu).albedo, again.look.transferFunction.at(hu).albedo) <
                    2e-3f);
        }
        QVERIFY(std::abs(look.look.transferFunction.nodes[0].roughness -
                         again.look.transferFunction.nodes[0].roughness) < 1e-3f);
    }

    void whatCannotBeShownIsSaid() {
        const auto gradient = propertyFromText(replaced(kText, "4 0 1 255 1", "4 0 0.2 255 1"), "");
        QVERIFY(gradient->simplified);
        QVERIFY(lookOf(*gradient, "x", base())->doesNotShow.find("gradient") != std::string::npos);
        QVERIFY(propertyFromJson(replaced(kJson, "\"midpoint\": 0.5", "\"midpoint\": 0.2"), "")->simplified);
        const auto opaque = propertyFromText(replaced(kText, "0.616071", "1"), "");
        QVERIFY(lookOf(*opaque, "x", base()));
    }

    void badFilesGetOneSentence_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(says);
        };
        row("empty", "", "interpolation: is missing");
        row("short", "1\n1\n0.9\n", "ambient: is missing");
        row("no curve", kText.substr(0, 19), "opacity: is missing");
        row("letters", replaced(kText, "0.169643", "much"), "\"much\", which is no number");
        row("not finite", replaced(kText, "0.169643", "nan"), "no number");
        row("count", replaced(kText, "14 ", "16 "), "says it holds 16 values and holds 14");
        row("half a point", replaced(kText, "4 0 1 255 1", "3 0 1 255"), "not whole");
        row("no points",
            replaced(kText,
                     "14 -3024 0 -86.9767 0 45.3791 0.169643 139.919 0.589286 347.907 0.607143 "
                     "1224.16 0.607143 3071 0.616071",
                     "0"),
            "opacity: has no points");
        row("opacity", replaced(kText, "0.169643", "7"), "opacity: is 7, must be from 0 to 1");
        row("colour", replaced(kText, "0.25098", "-1"), "colour: holds -1, each number must be from 0 to 1");
        row("descending", replaced(kText, "45.3791 0.169643", "-100 0.1"), "opacity: has points that do not ascend");
        row("far", replaced(kText, "3071 0.616071", "1e9 0.6"), "must be from -32768");
        row("binary", std::string("\0\1\2\3", 4), "which is no number");
        row("json", "{ no json", "is no JSON");
        row("json empty", "{}", "volumeProperties: is missing");
        row("json none", quoted("{'volumeProperties': []}"), "volumeProperties: is empty");
        row("json component", quoted("{'volumeProperties': [{'components': []}]}"), "components: is empty");
        row("json curve", replaced(kJson, "scalarOpacity\":", "opacity\":"), "scalarOpacity: is missing");
        row("json colour", replaced(kJson, "[1, 0.5, 0.25]", "[1, 0.5]"), "color");
        row("json distance", replaced(kJson, "UnitDistance\": 2", "UnitDistance\": 0"), "unit distance: is 0, must be");
    }
    void badFilesGetOneSentence() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, says);
        const auto property = text.startsWith('{') ? propertyFromJson(text.toStdString(), "file")
                                                   : propertyFromText(text.toStdString(), "file");
        std::string told = property ? "" : property.error().text();
        if (property)
            if (const auto look = lookOf(*property, "x", base()); !look)
                told = look.error().text();
        QVERIFY2(!told.empty() && QByteArray::fromStdString(told).contains(says), told.c_str());
        QVERIFY2(told.find('\n') == std::string::npos, told.c_str());
    }
};

QTEST_APPLESS_MAIN(SlicerTest)
#include "slicer_test.moc"
