#pragma once
/// Options of the commands that render images to files: when they stop, and what renders.

#include <QCommandLineParser>

#include <string>

#include "app/cli/render/render_options.h"

namespace pdr::app {

/// Returns the option `--device`.
QCommandLineOption deviceOption();

/// Adds the options for stops, device, denoising, annotations and render nodes.
void describeImageOptions(QCommandLineParser& parser);
/// Adds those alone that concern a film that has been taken: device, denoising and annotations.
void describeFinishOptions(QCommandLineParser& parser);

/// Reads these options and `--threads` into `options`. Throws an Error that names the first wrong option.
void readImageOptions(const QCommandLineParser& parser, RenderOptions& options);

/// Reads `--threads` and the options of describeFinishOptions() into `options`. Throws as above.
void readFinishOptions(const QCommandLineParser& parser, RenderOptions& options);

/// Reads `--threads`; 0 if it was not given. Throws an Error if it is no number of threads.
int readThreads(const QCommandLineParser& parser);

/// Reads the name of the device. Whether the device exists is known only when it is opened.
std::string readDevice(const QCommandLineParser& parser);

}  // namespace pdr::app
