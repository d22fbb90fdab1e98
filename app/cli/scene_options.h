#pragma once
/// The options of all commands that render: what is shown, and how.

#include <QCommandLineParser>

#include <optional>

#include "app/cli/scene_input.h"

namespace pdr::app {

void describeSceneOptions(QCommandLineParser& parser);

/// `command`: the word that they were given to. Throws an Error that names the first option that is wrong.
SceneInput readSceneOptions(const QCommandLineParser& parser, const QString& command);

/// A pixel such as 400,300; none: the option of that name was not given. Throws an Error where it is none.
std::optional<ivec2> readPixel(const QCommandLineParser& parser, const QString& name);

}  // namespace pdr::app
