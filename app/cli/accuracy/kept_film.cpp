#include "app/cli/accuracy/kept_film.h"

#include <cstring>
#include <fstream>
#include <span>
#include <type_traits>
#include <utility>

#include "render/base/replacing_file.h"
#include "render/base/version.h"
#include "render/kernel/random.h"
#include "render/scene/environment_image.h"
#include "render/scene/scene_file.h"

namespace pdr::app {
namespace {

static_assert(std::is_trivially_copyable_v<Moments> && std::is_trivially_copyable_v<PixelSums> &&
              std::is_trivially_copyable_v<Health>);

constexpr char kMagic[8] = {'P', 'D', 'R', 'f', 'i', 'l', 'm', '1'};

struct Head {
    char magic[8];
    std::uint64_t key, samples;
    double seconds;
    std::int32_t width, height;
    std::uint64_t pixelBytes;  ///< that one takes: another layout is another file
};
constexpr std::uint64_t kPixelBytes = sizeof(Moments) + sizeof(PixelSums);

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

/// All of a file that comes after its head, in order.
template <class Look>
bool parts(FilmContent& content, std::uint64_t& checksum, const Look& look) {
    return look(content.moments.data(), content.moments.size() * sizeof(Moments)) &&
           look(content.block.data(), content.block.size() * sizeof(PixelSums)) &&
           look(&content.health, sizeof content.health) && look(&checksum, sizeof checksum);
}

std::uint64_t checksumOf(const FilmContent& content) {
    std::uint64_t sum = hashed(1, std::as_bytes(std::span(content.moments)));
    sum = hashed(sum, std::as_bytes(std::span(content.block)));
    return hashed(sum, std::as_bytes(std::span(&content.health, 1)));
}

}  // namespace

std::uint64_t filmKey(const Scene& scene, const std::string& device) {
    SceneFile file;
    file.scene = scene;
    file.scene.volume = nullptr;
    file.scene.environment.image = nullptr;
    std::uint64_t key = hashed(hashed(hashed(1, PDR_VERSION), device), sceneText(file));
    if (scene.environment.image)
        key = hashed(key, std::as_bytes(std::span(scene.environment.image->texels)));
    return hashed(key, std::as_bytes(std::span(scene.volume->voxels())));
}

Result<void> writeFilm(const KeptFilm& kept, std::uint64_t key, const std::filesystem::path& path) {
    auto file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    FilmContent content = kept.film->content();
    Head head{{},         key, kept.film->samplesPerPixel(), kept.seconds, kept.film->size().x, kept.film->size().y,
              kPixelBytes};
    std::memcpy(head.magic, kMagic, sizeof kMagic);
    std::uint64_t checksum = checksumOf(content);
    file->write(&head, sizeof head);
    parts(content, checksum, [&](const void* bytes, std::size_t count) { return file->write(bytes, count); });
    return file->commit();
}

std::optional<KeptFilm> readFilm(const Scene& scene, std::uint64_t key, const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    Head head{};
    if (!file.read(reinterpret_cast<char*>(&head), sizeof head) ||
        std::memcmp(head.magic, kMagic, sizeof kMagic) != 0 || head.key != key || head.pixelBytes != kPixelBytes ||
        ivec2(head.width, head.height) != scene.film)
        return std::nullopt;
    FilmContent content = Film(scene.film, scene.revision).content();
    std::uint64_t checksum = 0;
    const bool whole = parts(content, checksum, [&](void* bytes, std::size_t count) {
        return bool(file.read(static_cast<char*>(bytes), std::streamsize(count)));
    });
    if (!whole || checksum != checksumOf(content))
        return std::nullopt;
    content.progress.advance(wholeImage(scene.film), head.samples);
    return KeptFilm{std::make_shared<Film>(scene.revision, std::move(content)), head.seconds};
}

}  // namespace pdr::app
