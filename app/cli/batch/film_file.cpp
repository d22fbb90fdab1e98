#include "app/cli/batch/film_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <span>
#include <type_traits>
#include <utility>

#include "app/wire/content_hash.h"
#include "render/base/image_size.h"
#include "render/base/plain_file.h"
#include "render/base/replacing_file.h"
#include "render/base/version.h"
#include "render/kernel/random.h"
#include "render/scene/environment_image.h"
#include "render/scene/range.h"
#include "render/scene/scene_file.h"
#include "render/tiles/reference_tiles.h"

namespace pdr::app {
namespace {

constexpr std::array<char, 8> kMagic{'P', 'D', 'R', 'f', 'i', 'l', 'm', 0};
constexpr std::uint32_t kVersion = 3;  ///< version of the fields below and their order

struct Head {
    std::array<char, 8> magic = kMagic;
    std::uint32_t version = kVersion;
    FilmOrigin origin;
    std::int32_t count = 0;  ///< shares in the file
};

struct ShareHead {
    std::int32_t number = 0;
    double seconds = 0;
    Health health;
};

template <class T>
constexpr bool kIsArrayOfBytes = false;
template <class Byte, std::size_t N>
constexpr bool kIsArrayOfBytes<std::array<Byte, N>> = sizeof(Byte) == 1;

/// Numbers, vectors of numbers and rows of bytes: types without padding bytes.
template <class Field>
concept Plain = std::is_arithmetic_v<Field> || std::is_same_v<Field, vec3> || std::is_same_v<Field, dvec3> ||
    std::is_same_v<Field, ivec2> || kIsArrayOfBytes<Field>;

template <class Part, class Of>
concept Is = std::is_same_v<std::remove_cvref_t<Part>, Of>;

/// Calls visit(field) for each field of a part of the file, in file order.
template <class Visit>
void eachField(Is<Head> auto&& head, const Visit& visit) {
    visit(head.magic);
    visit(head.version);
    visit(head.origin.program);
    visit(head.origin.bits);
    visit(head.origin.scene);
    visit(head.origin.voxels);
    visit(head.origin.seed);
    visit(head.origin.size);
    visit(head.origin.samples);
    visit(head.origin.shares);
    visit(head.count);
}

template <class Visit>
void eachField(Is<ShareHead> auto&& head, const Visit& visit) {
    visit(head.number);
    visit(head.seconds);
    for (auto& fault : head.health.faults) {
        visit(fault.count);
        visit(fault.sample);
        visit(fault.pixel);
    }
}

template <class Visit>
void eachField(Is<Moments> auto&& moments, const Visit& visit) {
    visit(moments.mean);
    visit(moments.m2);
    visit(moments.count);
    visit(moments.evenMean);
    visit(moments.evenCount);
}

template <class Visit>
void eachField(Is<PixelSums> auto&& sums, const Visit& visit) {
    visit(sums.sum);
    visit(sums.sumOfSquares);
    visit(sums.evenSum);
    visit(sums.evenCount);
    visit(sums.count);
    visit(sums.seen);
}

/// Returns the bytes that a part takes in a file.
template <class Part>
std::uintmax_t bytesOf() {
    std::uintmax_t bytes = 0;
    eachField(Part(), [&]<Plain Field>(const Field&) { bytes += sizeof(Field); });
    return bytes;
}

/// The sum over all bytes of a file, which tells damage, not forgery.
class Checksum {
  public:
    void add(const void* bytes, std::size_t count) {
        const auto* from = static_cast<const char*>(bytes);
        for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
            std::uint64_t word = count;
            std::memcpy(&word, from + i, std::min(sizeof word, count - i));
            sum_ = mixBits(sum_ + word + 0x9E3779B97F4A7C15ull);
        }
    }
    std::uint64_t sum() const { return sum_; }

  private:
    std::uint64_t sum_ = 1;
};

class FieldWriter {
  public:
    explicit FieldWriter(ReplacingFile& file) : file_(file) {}

    template <class Part>
    void write(const Part& part) {
        eachField(part, [&]<Plain Field>(const Field& field) {
            file_.write(&field, sizeof field);
            checksum_.add(&field, sizeof field);
        });
    }
    void writeChecksum() {
        const std::uint64_t sum = checksum_.sum();
        file_.write(&sum, sizeof sum);
    }

  private:
    ReplacingFile& file_;
    Checksum checksum_;
};

class FieldReader {
  public:
    explicit FieldReader(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

    /// Reads the fields of `part`. Fields beyond the end of the file remain as they are.
    template <class Part>
    void read(Part& part) {
        eachField(part, [&]<Plain Field>(Field& field) {
            file_.read(reinterpret_cast<char*>(&field), sizeof field);
            checksum_.add(&field, sizeof field);
        });
    }
    /// Returns whether the checksum fits everything that was read.
    bool checksumFits() {
        std::uint64_t written = 0;
        file_.read(reinterpret_cast<char*>(&written), sizeof written);
        return file_ && written == checksum_.sum();
    }

  private:
    std::ifstream file_;
    Checksum checksum_;
};

constexpr std::array kKey{std::byte{'f'}, std::byte{'i'}, std::byte{'l'}, std::byte{'m'}};

ContentHash hashOfScene(const Scene& scene) {
    wire::ContentHash hash(kKey);
    SceneFile file;
    file.scene = scene;
    file.scene.volume = nullptr;
    file.scene.environment.image = nullptr;
    if (scene.parts.map)
        file.parts.labels = "labels";
    const std::string text = sceneText(file);
    hash.add(std::as_bytes(std::span(text)));
    if (scene.environment.image)
        hash.add(std::as_bytes(std::span(scene.environment.image->texels)));
    return hash.finish();
}

ContentHash hashOfVoxels(const Scene& scene) {
    wire::ContentHash hash(kKey);
    hash.add(std::as_bytes(std::span(scene.volume->voxels())));
    if (scene.parts.map)
        hash.add(std::as_bytes(std::span(scene.parts.map->labels)));
    return hash.finish();
}

Error noFilm(const std::string& what, const std::filesystem::path& path) {
    return {what, path.string(), "Name files that \"pdrender-cli render --share\" has written."};
}

/// Returns whether the numbers are those of a film; what follows is read only then.
bool isSound(const Head& head) {
    const FilmOrigin& origin = head.origin;
    const Range side{1, kLongestSide};
    return side.holds(origin.size.x) && side.holds(origin.size.y) && origin.samples >= 1 && origin.shares >= 1 &&
           origin.shares <= mostShares(origin.size) && head.count >= 1 && head.count <= origin.shares;
}

}  // namespace

Result<FilmOrigin> filmOrigin(const Scene& scene, Device& device, std::uint64_t samples, int shares) {
    const auto tiles = referenceTiles(device);
    if (!tiles)
        return tiles.error();
    FilmOrigin origin{{},
                      wire::contentHash(kKey, *tiles),
                      hashOfScene(scene),
                      hashOfVoxels(scene),
                      scene.seed,
                      scene.film,
                      samples,
                      shares};
    std::string_view(PDR_VERSION).copy(origin.program.data(), origin.program.size() - 1);
    return origin;
}

void addTile(FilmShare& share, const Film& film) {
    const FilmContent content = film.content();
    share.moments.insert(share.moments.end(), content.moments.begin(), content.moments.end());
    share.block.insert(share.block.end(), content.block.begin(), content.block.end());
    share.health.add(content.health);
}

std::shared_ptr<const Film> wholeFilm(const SavedFilm& saved, std::uint64_t revision) {
    const ivec2 size = saved.origin.size;
    FilmContent whole = Film(size, revision).content();
    for (const FilmShare& share : saved.shares) {
        std::size_t next = 0;
        for (const Tile& tile : tilesOf({share.number, saved.origin.shares}, size))
            for (int y = tile.y; y < tile.y + tile.height; ++y, next += std::size_t(tile.width)) {
                const std::size_t to = std::size_t(y) * std::size_t(size.x) + std::size_t(tile.x);
                std::copy_n(share.moments.begin() + std::ptrdiff_t(next), tile.width,
                            whole.moments.begin() + std::ptrdiff_t(to));
                std::copy_n(share.block.begin() + std::ptrdiff_t(next), tile.width,
                            whole.block.begin() + std::ptrdiff_t(to));
            }
        whole.health.add(share.health);
    }
    whole.progress.advance(wholeImage(size), saved.origin.samples);
    return std::make_shared<const Film>(revision, std::move(whole));
}

SavedFilm savedFilm(const Film& film, const FilmOrigin& origin, double seconds) {
    SavedFilm saved{origin, {{1, seconds, {}, {}, {}}}};
    addTile(saved.shares.front(), film);
    return saved;
}

Result<void> writeFilm(const SavedFilm& saved, const std::filesystem::path& path) {
    auto file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    FieldWriter fields(*file);
    fields.write(Head{kMagic, kVersion, saved.origin, std::int32_t(saved.shares.size())});
    for (const FilmShare& share : saved.shares)
        fields.write(ShareHead{share.number, share.seconds, share.health});
    for (const FilmShare& share : saved.shares)
        for (std::size_t i = 0; i < share.moments.size(); ++i) {
            fields.write(share.moments[i]);
            fields.write(share.block[i]);
        }
    fields.writeChecksum();
    return file->commit();
}

Result<SavedFilm> readFilm(const std::filesystem::path& path) {
    if (auto plain = checkPlainFile(path); !plain)
        return plain.error();
    const std::uintmax_t bytes = std::filesystem::file_size(path);
    FieldReader fields(path);
    Head head;
    fields.read(head);
    if (bytes < bytesOf<Head>() || head.magic != kMagic)
        return noFilm("this is no film", path);
    if (head.version != kVersion)
        return noFilm("this film was written by another version of PD-Render", path);
    const Error damaged{"this film is damaged", path.string(), "Render its share again."};
    if (!isSound(head) || bytes < bytesOf<Head>() + std::uintmax_t(head.count) * bytesOf<ShareHead>())
        return damaged;
    SavedFilm saved{head.origin, {}};
    std::uintmax_t pixels = 0;
    for (std::int32_t i = 0, before = 0; i < head.count; ++i) {
        ShareHead share;
        fields.read(share);
        if (share.number <= before || share.number > head.origin.shares)
            return damaged;
        before = share.number;
        pixels += pixelsIn(tilesOf({share.number, head.origin.shares}, head.origin.size));
        saved.shares.push_back({share.number, share.seconds, {}, {}, share.health});
    }
    // The length is known now: nothing is reserved for pixels that the file does not hold.
    if (bytes != bytesOf<Head>() + std::uintmax_t(head.count) * bytesOf<ShareHead>() +
                     pixels * (bytesOf<Moments>() + bytesOf<PixelSums>()) + sizeof(std::uint64_t))
        return damaged;
    for (FilmShare& share : saved.shares) {
        const std::size_t own = pixelsIn(tilesOf({share.number, head.origin.shares}, head.origin.size));
        share.moments.resize(own);
        share.block.resize(own);
        for (std::size_t i = 0; i < own; ++i) {
            fields.read(share.moments[i]);
            fields.read(share.block[i]);
        }
    }
    if (!fields.checksumFits())
        return damaged;
    return saved;
}

}  // namespace pdr::app
