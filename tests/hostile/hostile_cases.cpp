// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: hostile_cases FILE FIRST
// Runs the cases of a file, each with its length before it (32 bits), from number FIRST on, and prints a line
// before and one after each. A case that ends the program, as a sanitizer does, is the last one that it
// named.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <vector>

#include <csignal>
#include <sys/resource.h>

#include "checked_run.h"

namespace
{

constexpr rlim_t kMostSeconds = 60; ///< of a processor for one case; the sanitizers take most of it

double ProcessorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// From here on; the program ends by SIGXCPU where a case takes longer.
void LimitProcessorTime()
{
    rlimit limit{};
    getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur = static_cast<rlim_t>(ProcessorSeconds()) + kMostSeconds + 1;
    setrlimit(RLIMIT_CPU, &limit);
}

void Run(std::uint32_t number, const std::uint8_t* bytes, std::size_t size)
{
    std::printf("%u\n", number);
    std::fflush(stdout);
    LimitProcessorTime();
    const double start = ProcessorSeconds();
    const hostile::Ending ending = hostile::CheckedRun(hostile::CaseOf(bytes, size));
    const char* kinds[] = {"done", "refused", "fault"};
    std::printf("%s\t%f\t%s\n", kinds[ending.kind], ProcessorSeconds() - start, ending.said.c_str());
    std::fflush(stdout);
}

} // namespace

int main(int count, char** words)
{
    if (count != 3) return 2;
    std::ifstream file(words[1], std::ios::binary);
    if (!file) return 1;
    const auto first = static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10));
    std::uint32_t size = 0;
    for (std::uint32_t number = 0; file.read(reinterpret_cast<char*>(&size), sizeof size); ++number) {
        std::vector<std::uint8_t> bytes(size); // of exactly its size: a step beyond is seen
        if (!file.read(reinterpret_cast<char*>(bytes.data()), size)) return 1;
        if (number >= first) Run(number, bytes.data(), bytes.size());
    }
    return 0;
}
