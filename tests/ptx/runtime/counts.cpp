#include "tests/ptx/runtime/counts.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

#include "tests/ptx/runtime/kernels.h"

namespace pdr::ptx {

namespace {

void write(std::ostream& to, const Kernel& kernel, std::size_t module) {
    to << "kernel " << kernel.name << ' ' << module << ' ' << kernel.launches << '\n';
    for (std::size_t b = 0; b < kernel.counts.size(); ++b) {
        const Block& block = kernel.program->blocks[b];
        const BlockCounts& counts = kernel.counts[b];
        if (counts.warps > 0 && block.statements > 0)
            to << "block " << block.firstLine << ' ' << block.lastLine << ' ' << block.statements << ' ' << counts.warps
               << ' ' << counts.lanes << '\n';
    }
}

}  // namespace

void writeCounts(const std::string& folder, const Kernels& kernels) {
    std::map<const EmbeddedModule*, std::size_t> numbers;
    std::ofstream counts(folder + "/counts.txt");
    for (const auto& [host, kernel] : kernels.all()) {
        const auto [module, isNew] = numbers.emplace(kernel.module, numbers.size());
        if (isNew)
            std::ofstream(folder + '/' + std::to_string(module->second) + ".ptx") << kernel.module->ptxText();
        write(counts, kernel, module->second);
    }
    if (!counts.flush()) {
        std::fprintf(stderr, "ptx: %s cannot be written to\n", folder.c_str());
        std::_Exit(3);
    }
}

}  // namespace pdr::ptx
