#pragma once
/// Options of pdrender-node, from its command line and its environment; the command line has precedence.

#include <QStringList>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/remote/address.h"
#include "render/base/result.h"

namespace pdr::node {

struct NodeOptions {
    std::optional<remote::Address> coordinator;  ///< to dial; one of the two
    std::optional<remote::Address> listen;       ///< where to be dialled
    QString bundle;                              ///< folder of certificates; empty: none
    QString name;                                ///< that users see; this machine's by default
    std::string device = "auto";                 ///< as openDevice() takes it
    int threads = 0;                             ///< of the CPU; 0 = one per core
    std::chrono::minutes idle{0};                ///< without work, before it ends; 0: never
    std::chrono::seconds drain{8};               ///< for what is on its way when it is to end
    std::chrono::seconds giveUp{120};            ///< on a coordinator that cannot be reached
    QString makeCertificates;                    ///< folder to write a bundle into; empty: none is wanted
    bool help = false, version = false;
};

/// `arguments` behind the program's name; `environment` tells the value of a variable, empty where it is not set.
/// Errors name the option in `where`.
Result<NodeOptions> nodeOptions(const QStringList& arguments, const std::function<QString(const char*)>& environment);
std::string nodeHelp();

}  // namespace pdr::node
