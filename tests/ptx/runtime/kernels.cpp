#include "tests/ptx/runtime/kernels.h"

#include <algorithm>

#include "tests/ptx/code/decode.h"

namespace pdr::ptx {

const std::string& EmbeddedModule::ptxText() const {
    const auto found = std::ranges::find_if(code, &EmbeddedCode::isPtx);
    if (found == code.end())
        throw NotKnown("a module without PTX");
    return found->content;
}

const Module& EmbeddedModule::ptx() {
    if (!text)
        text.emplace(ptxText());
    return *text;
}

const Program& Kernel::decoded(const Settings& settings) {
    if (program == nullptr) {
        program = decode(module->ptx().kernel(name), settings.byAddress);
        counts.resize(program->blocks.size());
    }
    return *program;
}

bool Kernel::runsOn(int capability) const {
    return std::ranges::any_of(module->code, [&](const EmbeddedCode& one) {
        return one.architecture <= capability && (one.isPtx || one.architecture / 10 == capability / 10);
    });
}

int Kernel::registers() const {
    int most = 0;
    for (const EmbeddedCode& one : module->code)
        if (!one.isPtx)
            most = std::max(most, registersIn(one.content, name));
    return most;
}

int Kernel::blocksPerProcessor(int threads) const {
    constexpr int kRegisters = 65536, kThreads = 2048, kBlocks = 32, kWithoutMachineCode = 4;
    const int each = registers();
    if (each == 0)
        return kWithoutMachineCode;
    const int perBlock = (each + 7) / 8 * 8 * threads;
    return std::min({kRegisters / perBlock, kThreads / threads, kBlocks});
}

EmbeddedModule& Kernels::addModule(std::vector<EmbeddedCode> code) {
    modules_.push_back(std::make_unique<EmbeddedModule>());
    modules_.back()->code = std::move(code);
    return *modules_.back();
}

void Kernels::add(const void* host, EmbeddedModule& module, const char* name) {
    byHost_.insert_or_assign(host, Kernel{.module = &module, .name = name});
}

Kernel* Kernels::find(const void* host) {
    const auto found = byHost_.find(host);
    return found != byHost_.end() ? &found->second : nullptr;
}

}  // namespace pdr::ptx
