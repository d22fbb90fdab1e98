/// Undo and redo after hundreds of edits of all kinds, in random order.

#include <QTest>
#include <functional>
#include <random>

#include "render/scene/orbit.h"
#include "tests/support/desktop/told_document.h"

namespace pdr::app {
namespace {

/// Everything that undo brings back, and the scene that an image is made of: the same scene makes the same bits.
struct State {
    explicit State(const Document& document)
        : plan(document.plan()), scene(document.scene()), display(document.display()) {
        scene.revision = 0;
    }
    bool operator==(const State&) const = default;

    Plan plan;
    Scene scene;
    Display display;
};

/// Makes random edits of a document, of every kind that can be undone.
class Hand {
  public:
    Hand(Document& document, unsigned seed) : document_(document), random_(seed) {}

    void edit() { kinds_[random_() % kinds_.size()](); }

  private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    int choice(int count) { return int(random_() % unsigned(count)); }
    dvec3 place() { return {number(-20, 20), number(80, 120), number(180, 220)}; }

    /// Turns the view: some moves, and a rest.
    void turn() {
        const auto turned = [&] { return orbited(document_.scene().camera, {number(-0.3, 0.3), number(-0.3, 0.3)}); };
        for (int moves = choice(4); moves > 0; --moves)
            document_.setCamera(turned(), true);
        document_.setCamera(turned(), false);
    }
    void curve() {
        Look look = document_.setup().look;
        look.transferFunction.nodes.front().hu = number(-400, 200);
        look.phaseG = float(number(-0.9, 0.9));
        document_.setLook(look);
    }
    void light() {
        Look look = document_.setup().look;
        look.environment.radiance = vec3(number(0, 2), number(0, 2), number(0, 2));
        document_.setLook(look, true);
        look.environment.radiance *= 0.5f;
        document_.setLook(look);
    }
    void cut() {
        Clip clip;
        if (choice(3) > 0)
            clip.box = ClipBox{place() - 5.0, place() + 25.0};
        document_.setClip(clip);
    }
    void measure() {
        Plan plan = document_.plan();
        auto& all = plan.measurements;
        if (all.size() > 3 && choice(2) > 0)
            all.erase(all.begin() + choice(int(all.size())));
        else if (!all.empty() && choice(3) == 0)
            all.back().name = std::to_string(choice(100));
        else
            all.push_back(
                {random_(), MeasureKind::distance, "", {measure::typedPlace(place()), measure::typedPlace(place())}});
        document_.edit(std::move(plan));
    }
    void window() {
        Navigation navigation = document_.plan().navigation;
        navigation.window = {number(-500, 500), number(10, 3000)};
        navigation.layout = choice(2) ? ViewLayout::beside : ViewLayout::image;
        document_.navigate(navigation);
    }

    Document& document_;
    std::mt19937 random_;
    std::vector<std::function<void()>> kinds_{
        [&] { turn(); },
        [&] { document_.setView(choice(2) ? StandardView::left : StandardView::superior); },
        [&] { document_.setFocus(number(20, 200)); },
        [&] { document_.resetView(); },
        [&] { document_.setBackground(choice(2) ? std::optional(vec3(number(0, 1))) : std::nullopt); },
        [&] { document_.setModel(kModels[choice(int(std::size(kModels)))]); },
        [&] { document_.chooseLook(choice(2)); },
        [&] { curve(); },
        [&] { light(); },
        [&] { cut(); },
        [&] { document_.setBrightness(number(-3, 3)); },
        [&] { document_.setEstimator(choice(2) ? Estimator::unbiased : Estimator::kroesMarch); },
        [&] { document_.setSchedule({choice(2) ? Schedule::Kind::pd : Schedule::Kind::kroes}); },
        [&] { document_.moveCrosshair(place()); },
        [&] { window(); },
        [&] { measure(); },
    };
};

}  // namespace

class RandomUndoTest : public QObject {
    Q_OBJECT

  private slots:
    /// Each step back or forth is a state that was there before, in the same order, and both ends are met exactly.
    void fiveHundredEditsAreUndoneAndRedoneExactly() {
        constexpr unsigned kRounds = 5;  // the way back is long, but ends
        constexpr int kEdits = 100;
        for (unsigned round = 0; round < kRounds; ++round) {
            Told told;
            Document& document = told.document;
            Hand hand(document, round);
            std::vector<State> states{State(document)};
            for (int i = 0; i < kEdits; ++i) {
                hand.edit();
                states.emplace_back(document);
            }
            auto at = states.end() - 1;
            int steps = 0;
            for (; document.canUndo(); ++steps) {
                document.undo();
                const State now(document);
                do
                    QVERIFY2(at != states.begin(), qPrintable(QString("round %1, step %2").arg(round).arg(steps)));
                while (!(*--at == now));
            }
            QVERIFY(State(document) == states.front());
            QVERIFY(steps > kEdits / 2);
            for (at = states.begin(); document.canRedo(); --steps) {
                document.redo();
                const State now(document);
                do
                    QVERIFY(at + 1 != states.end());
                while (!(*++at == now));
            }
            QVERIFY(State(document) == states.back() && steps == 0);
        }
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::RandomUndoTest)
#include "random_undo_test.moc"
