#include "app/cli/accuracy/kept_film.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <span>
#include <type_traits>
#include <utility>

#include "render/base/plain_file.h"
#include "render/base/replacing_file.h"
#include "render/base/version.h"
#include "render/kernel/random.h"
#include "render/scene/environment_image.h"
#include "render/scene/scene_file.h"

namespace pdr::app {
namespace {

constexpr char kMagic[8] = {'P', 'D', 'R', 'f', 'i', 'l', 'm', 0};
constexpr std::uint32_t kVersion = 2;  ///< version of the fields below and their order

struct Head {
    char magic[8];
    std::uint32_t version;
    std::uint64_t key, samples;
    double seconds;
    std::int32_t width, height;
};

std::uint64_t hashed(std::uint64_t hash, std::span<const std::byte> bytes) {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
        std::uint64_t word = bytes.size();
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        hash = mixBits(hash + word + 0x9E3779B97F4A7C15ull);
    }
    return hash;
}

std::uint64_t hashed(std::uint64_t hash, const std::string& text) {
    return hashed(hash, std::as_bytes(std::span(text)));
}

/// Numbers and vectors of numbers: types without padding bytes.
template <class Field>
concept Plain = std::is_arithmetic_v<Field> || std::is_same_v<Field, vec3> || std::is_same_v<Field, dvec3> ||
    std::is_same_v<Field, char[8]>;

/// Calls visit(field) for each field of a part of the file, in file order.
template <class Visit>
void eachField(auto&& head, const Visit& visit) requires std::is_same_v<std::remove_cvref_t<decltype(head)>, Head> {
    visit(head.magic);
    visit(head.version);
    visit(head.key);
    visit(head.samples);
    visit(head.seconds);
    visit(head.width);
    visit(head.height);
}

template <class Visit>
void eachField(auto&& content,
               const Visit& visit) requires std::is_same_v<std::remove_cvref_t<decltype(content)>, FilmContent> {
    for (auto& moments : content.moments) {
        visit(moments.mean);
        visit(moments.m2);
        visit(moments.count);
        visit(moments.evenMean);
        visit(moments.evenCount);
    }
    for (auto& sums : content.block) {
        visit(sums.sum);
        visit(sums.sumOfSquares);
        visit(sums.evenSum);
        visit(sums.evenCount);
        visit(sums.count);
        visit(sums.seen);
    }
    for (auto& fault : content.health.faults) {
        visit(fault.count);
        visit(fault.sample);
        visit(fault.pixel);
    }
}

class FieldWriter {
  public:
    explicit FieldWriter(ReplacingFile& file) : file_(file) {}

    template <class Part>
    void write(const Part& part) {
        eachField(part, [&]<Plain Field>(const Field& field) {
            file_.write(&field, sizeof field);
            checksum_ = hashed(checksum_, std::as_bytes(std::span(&field, 1)));
        });
    }
    void writeChecksum() { file_.write(&checksum_, sizeof checksum_); }

  private:
    ReplacingFile& file_;
    std::uint64_t checksum_ = 1;
};

class FieldReader {
  public:
    explicit FieldReader(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

    /// Reads the fields of `part`. Fields beyond the end of the file remain zero.
    template <class Part>
    void read(Part& part) {
        eachField(part, [&]<Plain Field>(Field& field) {
            file_.read(reinterpret_cast<char*>(&field), sizeof field);
            checksum_ = hashed(checksum_, std::as_bytes(std::span(&field, 1)));
        });
    }
    /// Returns whether the checksum fits everything that was read and the file ends after it.
    bool checksumFits() {
        std::uint64_t written = 0;
        file_.read(reinterpret_cast<char*>(&written), sizeof written);
        return file_ && written == checksum_ && file_.peek() == std::ifstream::traits_type::eof();
    }

  private:
    std::ifstream file_;
    std::uint64_t checksum_ = 1;
};

}  // namespace

std::uint64_t filmKey(const Scene& scene, const std::string& device) {
    SceneFile file;
    file.scene = scene;
    file.scene.volume = nullptr;
    file.scene.environment.image = nullptr;
    if (scene.parts.map)
        file.parts.labels = "labels";
    std::uint64_t key = hashed(hashed(hashed(1, PDR_VERSION), device), sceneText(file));
    if (scene.environment.image)
        key = hashed(key, std::as_bytes(std::span(scene.environment.image->texels)));
    if (scene.parts.map)
        key = hashed(key, std::as_bytes(std::span(scene.parts.map->labels)));
    return hashed(key, std::as_bytes(std::span(scene.volume->voxels())));
}

Result<void> writeFilm(const KeptFilm& kept, std::uint64_t key, const std::filesystem::path& path) {
    auto file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    Head head{{}, kVersion, key, kept.film->samplesPerPixel(), kept.seconds, kept.film->size().x, kept.film->size().y};
    std::memcpy(head.magic, kMagic, sizeof kMagic);
    FieldWriter fields(*file);
    fields.write(head);
    fields.write(kept.film->content());
    fields.writeChecksum();
    return file->commit();
}

std::optional<KeptFilm> readFilm(const Scene& scene, std::uint64_t key, const std::filesystem::path& path) {
    if (!checkPlainFile(path))
        return std::nullopt;
    FieldReader fields(path);
    Head head{};
    fields.read(head);
    if (std::memcmp(head.magic, kMagic, sizeof kMagic) != 0 || head.version != kVersion || head.key != key ||
        ivec2(head.width, head.height) != scene.film)
        return std::nullopt;
    FilmContent content = Film(scene.film, scene.revision).content();
    fields.read(content);
    if (!fields.checksumFits())
        return std::nullopt;
    content.progress.advance(wholeImage(scene.film), head.samples);
    return KeptFilm{std::make_shared<Film>(scene.revision, std::move(content)), head.seconds};
}

}  // namespace pdr::app
