/// A transfer function split into curves and joined again: what is not edited stays the same function.

#include <QTest>
#include <algorithm>
#include <random>

#include "render/scene/edit/needed_nodes.h"
#include "render/scene/edit/tissue_channels.h"

using namespace pdr;

namespace {

constexpr std::array kChannels{TissueChannel::opacity, TissueChannel::specular, TissueChannel::roughness,
                               TissueChannel::emission};

/// Returns the largest difference of all properties but `channel`, over the HU and their neighbourhood.
float differenceBeside(const TransferFunction& a, const TransferFunction& b, TissueChannel channel) {
    float largest = std::fabs(a.extinctionPerMm - b.extinctionPerMm);
    const auto compare = [&](const TransferNode& x, const TransferNode& y) {
        const auto differ = [](vec3 p, vec3 q) { return glm::length(p - q); };
        largest = std::max(largest, differ(x.albedo, y.albedo));
        for (const TissueChannel other : kChannels)
            if (other != channel)
                largest = std::max(largest, std::fabs(valueOf(x, other) - valueOf(y, other)));
    };
    for (float hu = -1500; hu < 3500; hu += 7.3f)
        compare(a.at(hu), b.at(hu));
    for (const TransferFunction* function : {&a, &b})
        for (const TransferNode& node : function->nodes) {
            compare(a.at(node.hu), b.at(node.hu));
            compare(a.before(node.hu), b.before(node.hu));
        }
    return largest;
}

/// Returns properties with corners at different places, and steps.
TransferFunction randomFunction(std::mt19937& random, int count) {
    const auto number = [&](double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(random));
    };
    TransferFunction function{1.5f, {}};
    TransferNode node;
    node.hu = -1024;
    for (int i = 0; i < count; ++i) {
        node.hu += i % 5 == 2 ? 0 : std::round(number(1, 4000.0 / count));
        node.opacity = i % 2 ? number(0, 1) : node.opacity;
        node.albedo = i % 3 ? node.albedo : vec3(number(0, 1), number(0, 1), number(0, 1));
        node.specular = i % 4 ? node.specular : vec3(number(0, 1));
        node.emission = i % 7 ? node.emission : vec3(number(0, 3), 0, number(0, 1));
        node.roughness = i % 6 ? node.roughness : number(0, 1);
        function.nodes.push_back(node);
    }
    return function;
}

}  // namespace

class TissueChannelsTest : public QObject {
    Q_OBJECT

  private slots:
    void aCurveHasTheCornersOfItsPropertyOnly() {
        TransferFunction function{2, std::vector<TransferNode>(5)};
        const float hu[] = {-100, 0, 100, 200, 300}, opacity[] = {0, 0, 0.5f, 1, 1};
        for (std::size_t i = 0; i < 5; ++i) {
            function.nodes[i].hu = hu[i];
            function.nodes[i].opacity = opacity[i];
            function.nodes[i].roughness = i < 2 ? 0.2f : 0.8f;
            function.nodes[i].albedo = i == 4 ? vec3(1) : vec3(0.5f);
        }
        const Curve expected{{-100, 0}, {0, 0}, {200, 1}};  // nobody needs the first one: it stays with the opacity
        QVERIFY(curveOf(function, TissueChannel::opacity) == expected);
        QVERIFY((curveOf(function, TissueChannel::roughness) == Curve{{0, 0.2f}, {100, 0.8f}}));
        QVERIFY((coloursOf(function) == std::vector<ColourStop>{{200, vec3(0.5f)}, {300, vec3(1)}}));
        QVERIFY((curveOf(function, TissueChannel::emission) == Curve{{-100, 0}}));
    }

    void takenApartAndPutTogetherItIsTheSame() {
        std::mt19937 random(1);
        for (int trial = 0; trial < 200; ++trial) {
            const TransferFunction function = randomFunction(random, 2 + trial % 40);
            for (const TissueChannel channel : kChannels) {
                const TransferFunction again = withCurve(function, channel, curveOf(function, channel));
                QVERIFY(again.check());
                QVERIFY(differenceBeside(function, again, channel) < 3e-5f);
                for (float hu = -1500; hu < 3500; hu += 3.7f)
                    QVERIFY(std::fabs(valueOf(function.at(hu), channel) - valueOf(again.at(hu), channel)) < 3e-5f);
            }
            QVERIFY(differenceBeside(function, withColours(function, coloursOf(function)), kChannels[0]) < 3e-5f);
        }
    }

    void anEditChangesItsOwnPropertyAlone() {
        std::mt19937 random(2);
        for (int trial = 0; trial < 200; ++trial) {
            const TransferFunction function = randomFunction(random, 2 + trial % 40);
            for (const TissueChannel channel : kChannels) {
                const Curve curve{{-700, 0.1f}, {33.5f, 0.9f}, {33.5f, 0.2f}, {5000, 1}};
                const TransferFunction edited = withCurve(function, channel, curve);
                QVERIFY2(edited.check(), edited.check() ? "" : edited.check().error().text().c_str());
                QVERIFY(differenceBeside(function, edited, channel) < 3e-5f);
                for (float hu = -1500; hu < 6000;
                     hu += 3.7f)  // between two hues the largest number is no straight line
                    QVERIFY(std::fabs(valueOf(edited.at(hu), channel) - valueAt(curve, hu)) < 3e-5f ||
                            channel == TissueChannel::emission);
                for (const CurvePoint& point : curve)
                    QVERIFY(std::fabs(valueOf(edited.at(point.hu), channel) - valueAt(curve, point.hu)) < 3e-5f);
                if (channel == TissueChannel::roughness)  // of the others hues and nodes that nobody needs count, too
                    QVERIFY(curveOf(edited, channel) == curve);
            }
        }
    }

    /// A point on the line that the user adds, and drags a hundred times, leaves nothing behind.
    void draggingLeavesNoNodesBehind() {
        TransferFunction function{1, {{0, 0}, {300, 1}}};
        function.nodes[1].albedo = vec3(0.3f);
        for (int i = 0; i < 100; ++i)
            function = withCurve(function, TissueChannel::opacity, {{0, 0}, {float(50 + i), 0.9f}, {300, 1}});
        QCOMPARE(function.nodes.size(), std::size_t(3));
        function = withCurve(function, TissueChannel::opacity, {{0, 0}, {150, 0.5f}, {300, 1}});
        QCOMPARE(curveOf(function, TissueChannel::opacity).size(), std::size_t(3));
    }

    void huesStayAndBlackBecomesGrey() {
        TransferFunction function{1, std::vector<TransferNode>(2)};
        function.nodes[1].hu = 100;
        function.nodes[1].emission = {2, 1, 0};
        const TransferFunction edited = withCurve(function, TissueChannel::emission, {{0, 0.5f}, {100, 4}});
        QVERIFY(edited.at(0).emission == vec3(0.5f));
        QVERIFY(glm::length(edited.at(100).emission - vec3(4, 2, 0)) < 1e-6f);
    }

    /// A smooth colour of many nodes, each of them nearly on the line of its neighbours, keeps its shape.
    void aThousandNodesKeepTheirShape() {
        TransferFunction function;
        for (int i = 0; i < 1000; ++i) {
            TransferNode node;
            node.hu = float(i);
            node.albedo = vec3(float(0.5 + 0.5 * std::sin(1e-3 * i)));
            function.nodes.push_back(node);
        }
        const TransferFunction edited = withCurve(function, TissueChannel::opacity, {{0, 0.1f}, {500.5f, 0.7f}});
        QVERIFY(differenceBeside(function, edited, TissueChannel::opacity) < 3e-6f);
        QVERIFY(edited.nodes.size() < 1000);
    }

    void roomAboveChangesNoExtinction() {
        std::mt19937 random(3);
        const TransferFunction function = randomFunction(random, 20), higher = withRoomFor(function, 6);
        QCOMPARE(higher.extinctionPerMm, 6.0f);
        for (float hu = -1500; hu < 3500; hu += 7.3f)
            QVERIFY(std::fabs(function.extinctionPerMm * function.opacityAt(hu) - 6 * higher.opacityAt(hu)) < 1e-6f);
        QVERIFY(withRoomFor(function, 0.5f) == function);
    }

    void shiftingAndWideningMoveAllProperties() {
        std::mt19937 random(4);
        const TransferFunction function = randomFunction(random, 20);
        const TransferFunction other = shiftedAndWidened(function, 100, 40, 2);
        QVERIFY(other.check());
        for (std::size_t i = 0; i < function.nodes.size(); ++i) {
            QCOMPARE(other.nodes[i].hu, 2 * (function.nodes[i].hu - 40) + 140);
            TransferNode back = other.nodes[i];
            back.hu = function.nodes[i].hu;
            QVERIFY(back == function.nodes[i]);
        }
        QVERIFY(shiftedAndWidened(function, 40000, 0, 1).check());
        QVERIFY(shiftedAndWidened(function, 0, 40, 1) == function);
    }
};

QTEST_GUILESS_MAIN(TissueChannelsTest)
#include "tissue_channels_test.moc"
