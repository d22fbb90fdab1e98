#include <QTest>

#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <random>
#include <string>
#include <thread>

#include "render/film/film.h"
#include "render/scene/scene_file.h"
#include "tests/support/scenes.h"
#include "tests/support/tissue_scene.h"

using namespace pdr;

namespace {

using Bytes = std::string;

/// Plain values one behind the other.
class Packet {
  public:
    Packet() = default;
    explicit Packet(Bytes bytes) : bytes_(std::move(bytes)) {}

    template <class T>
    Packet& put(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    template <class T>
    Packet& putAll(const T& values) {
        put(std::uint64_t(values.size()));
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]);
        return *this;
    }
    template <class T>
    T take() {
        T value;
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    template <class T>
    std::vector<T> takeAll() {
        std::vector<T> values(take<std::uint64_t>());
        std::memcpy(values.data(), bytes_.data() + at_, values.size() * sizeof(T));
        at_ += values.size() * sizeof(T);
        return values;
    }
    Bytes bytes() && { return std::move(bytes_); }

  private:
    Bytes bytes_;
    std::size_t at_ = 0;
};

/// One way of a connection.
class Wire {
  public:
    void send(Bytes bytes) {
        const std::lock_guard lock(mutex_);
        sent_.push_back(std::move(bytes));
        changed_.notify_one();
    }
    Bytes receive() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !sent_.empty(); });
        Bytes oldest = std::move(sent_.front());
        sent_.pop_front();
        return oldest;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Bytes> sent_;
};

Bytes toBytes(const Scene& scene) {
    SceneFile file;
    file.scene = scene;
    file.source.dicomFolder = "sent";
    Packet packet;
    packet.putAll(sceneText(file)).put(scene.revision).put(scene.volume->geometry());
    packet.putAll(std::vector(scene.volume->voxels().begin(), scene.volume->voxels().end()));
    return std::move(packet).bytes();
}

Scene sceneFrom(Bytes bytes) {
    Packet packet(std::move(bytes));
    const std::vector<char> text = packet.takeAll<char>();
    Scene scene = sceneFromText({text.data(), text.size()}, "the scene that was sent", "")->scene;
    scene.revision = packet.take<std::uint64_t>();
    const VolumeGeometry geometry = packet.take<VolumeGeometry>();
    const std::vector<std::int16_t> voxels = packet.takeAll<std::int16_t>();
    scene.volume = std::make_shared<Volume>(geometry, Voxels(voxels.begin(), voxels.end()));
    return scene;
}

Bytes toBytes(const TileResult& result) {
    Packet packet;
    packet.put(result.revision).put(result.tile).put(result.samples).put(result.health).putAll(result.sums);
    return std::move(packet).bytes();
}

TileResult resultFrom(Bytes bytes) {
    Packet packet(std::move(bytes));
    TileResult result;
    result.revision = packet.take<std::uint64_t>();
    result.tile = packet.take<Tile>();
    result.samples = packet.take<SampleRange>();
    result.health = packet.take<Health>();
    result.sums = packet.takeAll<PixelSums>();
    return result;
}

/// Another machine: it shares no pointer with the one that asks. First it is sent a scene, then tiles to render; an
/// empty message ends it.
class Node {
  public:
    Wire orders, results;

    Node()
        : thread_([this] {
              const Scene scene = sceneFrom(orders.receive());
              Flattener flattener;
              const auto prepared = flattener.prepare(scene);
              CpuTracer tracer(1);
              for (Bytes order = orders.receive(); !order.empty(); order = orders.receive()) {
                  Packet packet(std::move(order));
                  TileResult result{scene.revision, packet.take<Tile>(), packet.take<SampleRange>(), {}, {}};
                  result.sums.resize(std::size_t(result.tile.width) * std::size_t(result.tile.height));
                  tracer.trace(prepared->flat, result.tile, result.samples,
                               {result.sums.data(), result.tile.width, &result.health});
                  results.send(toBytes(result));
              }
          }) {}
    ~Node() { orders.send({}); }

    void order(const Tile& tile, SampleRange samples) {
        orders.send(std::move(Packet().put(tile).put(samples)).bytes());
    }

  private:
    std::jthread thread_;
};

}  // namespace

/// Machines that get bytes and give bytes make the picture that one machine makes.
class RemoteTilesTest : public QObject {
    Q_OBJECT

  private slots:
    void nodesMakeThePictureOfOneDevice_data() {
        QTest::addColumn<int>("nodes");
        for (const int nodes : {1, 2, 3, 7})
            QTest::newRow(std::to_string(nodes).c_str()) << nodes;
    }
    void nodesMakeThePictureOfOneDevice() {
        QFETCH(int, nodes);
        const Scene scene = test::tissueScene();
        std::vector<std::unique_ptr<Node>> all;
        for (int i = 0; i < nodes; ++i)
            all.emplace_back(std::make_unique<Node>())->orders.send(toBytes(scene));
        std::mt19937 random{unsigned(nodes)};
        Film film(scene.film, scene.revision);
        for (const SampleRange samples : {SampleRange{0, 5}, SampleRange{0, 64}, SampleRange{64, 36}}) {
            std::vector<int> asked(all.size());
            for (int y = 0; y < scene.film.y; y += kFilmCell)
                for (int x = 0; x < scene.film.x; x += 2 * kFilmCell) {
                    const Tile tile = film.progress().cellsAround({x, y, std::min(2 * kFilmCell, scene.film.x - x), 1});
                    const std::size_t node = random() % all.size();
                    all[node]->order(tile, samples);
                    ++asked[node];
                }
            for (std::size_t node = all.size(); node-- > 0;)  // not in the order in which they were asked
                for (int i = 0; i < asked[node]; ++i) {
                    const TileResult result = resultFrom(all[node]->results.receive());
                    const Result<void> merged = film.merge(result);
                    QVERIFY2(merged, merged ? "" : merged.error().text().c_str());
                    QVERIFY(!film.merge(result));  // twice
                }
        }
        QVERIFY(sameBits(film.content(), test::render(scene, 100).content()));
    }

    void whatANodeSendsTooLateOrForeignIsRefused() {
        Scene scene = test::tissueScene();
        scene.revision = 4;
        Node node;
        node.orders.send(toBytes(scene));
        Film film(scene.film, 5);  // an edit has come since
        node.order({0, 0, 16, 16}, {0, 8});
        QVERIFY(film.merge(resultFrom(node.results.receive())).error().what.ends_with("another scene"));
        film.restart(film.area(), 4);
        node.order({8, 0, 16, 16}, {0, 8});
        QVERIFY(film.merge(resultFrom(node.results.receive())).error().what.ends_with("no such tile is asked for"));
        node.order({0, 0, 16, 16}, {64, 8});
        QVERIFY(film.merge(resultFrom(node.results.receive())).error().what.ends_with("not the next ones"));
        QVERIFY(sameBits(film.content(), Film(scene.film, 4).content()));
    }
};

QTEST_GUILESS_MAIN(RemoteTilesTest)
#include "remote_tiles_test.moc"
