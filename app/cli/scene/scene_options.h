#pragma once
/// Options of all commands that render: what is shown, and how.

#include <QCommandLineParser>

#include <optional>

#include "app/cli/scene/scene_input.h"

namespace pdr::app {

void describeSceneOptions(QCommandLineParser& parser);

/// Reads the options. `command`: the command word that they belong to, for messages. Throws an Error that names the
/// first wrong option.
SceneInput readSceneOptions(const QCommandLineParser& parser, const QString& command);
/// Reads the options for the scene at `path`. Throws as above.
SceneInput readOptionsOfScene(const QCommandLineParser& parser, const std::filesystem::path& path);

/// Reads `--size`, such as 800x600; null if it was not given. Throws an Error if it is no size of an image.
std::optional<ivec2> readSize(const QCommandLineParser& parser);

/// Reads the pixel of the option `name`, such as 400,300; null if the option was not given. Throws an Error if it is
/// not a pixel.
std::optional<ivec2> readPixel(const QCommandLineParser& parser, const QString& name);

}  // namespace pdr::app
