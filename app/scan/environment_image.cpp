#include "app/scan/environment_image.h"

#include <utility>

#include "render/film/file/image_file.h"
#include "render/scene/sky_image.h"

namespace pdr::app {
namespace {

/// Reads and checks an environment image. `where` is used in error texts.
Result<EnvironmentImage> readImage(const std::filesystem::path& file, const std::string& where,
                                   const Progress& progress) {
    auto picture = readExr(file, progress);
    if (!picture)
        return Error{picture.error().what, where, picture.error().hint, picture.error().kind};
    EnvironmentImage image{picture->size, std::move(picture->pixels)};
    if (auto ok = image.check(); !ok)
        return Error{phrase("%1 %2", ok.error().where, ok.error().what), where, phrase("Choose another image.")};
    return image;
}

Result<std::shared_ptr<const EnvironmentImage>> shared(Result<EnvironmentImage> image) {
    if (!image)
        return image.error();
    return std::make_shared<const EnvironmentImage>(*std::move(image));
}

}  // namespace

Result<std::shared_ptr<const EnvironmentImage>> fetchEnvironment(const SceneFile& file) {
    if (file.environmentImage.empty())
        return std::shared_ptr<const EnvironmentImage>();
    const std::string where = file.environmentImage.string() + " (" + file.environmentField + ")";
    return shared(readImage(file.environmentImage, where, noProgress));
}

Result<std::shared_ptr<const EnvironmentImage>> readSky(const std::filesystem::path& file, const Progress& progress) {
    auto picture = readImage(file, file.string(), progress);
    if (!picture)
        return picture.error();
    auto scaled = scaledToMeanOne(*std::move(picture));
    return scaled ? shared(std::move(scaled)) : scaled.error().in(file.string());
}

}  // namespace pdr::app
