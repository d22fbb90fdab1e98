#include "app/environment_picture.h"

#include <utility>

#include "render/film/image_file.h"

namespace pdr::app {

Result<std::shared_ptr<const EnvironmentImage>> fetchEnvironment(const SceneFile& file) {
    if (file.environmentImage.empty())
        return std::shared_ptr<const EnvironmentImage>();
    auto picture = readExr(file.environmentImage);
    const std::string where = file.environmentImage.string() + " (" + file.environmentField + ")";
    if (!picture)
        return Error{picture.error().what, where, picture.error().hint};
    auto image = std::make_shared<EnvironmentImage>(EnvironmentImage{picture->size, std::move(picture->pixels)});
    if (auto ok = image->check(); !ok)
        return Error{ok.error().where + " " + ok.error().what, where, ok.error().hint};
    return std::shared_ptr<const EnvironmentImage>(std::move(image));
}

}  // namespace pdr::app
