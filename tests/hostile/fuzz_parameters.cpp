// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer on the parameters of all filters: any numbers and texts, as a host may hand them over. They are
// in their range afterward, or one is refused by its name.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "filters.h"
#include "parameters.h"
#include "values.h"

namespace
{

using namespace laplacian_simplify;

/// Reads from the front; nothing after the end.
class Reader
{
    const std::uint8_t* next_;
    std::size_t left_;

  public:
    Reader(const std::uint8_t* bytes, std::size_t size) : next_(bytes), left_(size) {}

    std::string Take(std::size_t wanted)
    {
        const std::size_t size = std::min(wanted, left_);
        std::string taken(reinterpret_cast<const char*>(next_), size);
        next_ += size;
        left_ -= size;
        return taken;
    }
    unsigned Byte()
    {
        const std::string one = Take(1);
        return one.empty() ? 0 : static_cast<unsigned char>(one[0]);
    }
};

/// Nothing, a number of any bits, a small whole one, or a text.
std::optional<GivenValue> TakeValue(Reader& reader)
{
    const unsigned kind = reader.Byte();
    if (kind % 4 == 0) return std::nullopt;
    if (kind % 4 == 1) return static_cast<double>(static_cast<std::int8_t>(reader.Byte()));
    const std::string bytes = reader.Take(kind % 4 == 2 ? sizeof(double) : kind / 4);
    if (kind % 4 == 3) return bytes;
    double number = 0;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
}

[[noreturn]] void Fail(const char* id, const std::string& what)
{
    std::fprintf(stderr, "fault: %s: %s\n", id, what.c_str());
    std::abort();
}

void CheckNumber(const Parameter& row, double number)
{
    const bool above = row.range.minimumIncluded ? number >= row.range.minimum : number > row.range.minimum;
    if (!(above && number <= row.range.maximum)) Fail(row.id, std::to_string(number) + " is out of range");
}

void CheckTaken(const Values& values, FilterId filter)
{
    for (const Parameter* row : ParametersOf(filter)) {
        if (row->type == ParameterType::Numbers) {
            for (const double number : values.Numbers(row->id)) CheckNumber(*row, number);
            continue;
        }
        CheckNumber(*row, values.Real(row->id));
        if (row->type != ParameterType::Real && values.Real(row->id) != std::floor(values.Real(row->id)))
            Fail(row->id, "is no whole number");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    Reader reader(bytes, size);
    const FilterId filter = Filters()[reader.Byte() % Filters().size()].id;
    const MeshFacts facts{reader.Byte() * std::size_t{16777216}, reader.Byte()};
    const char* asked = "";
    try {
        const Values values(
            filter, [&] { return facts; },
            [&](const Parameter& row) {
                asked = row.id;
                return TakeValue(reader);
            });
        CheckTaken(values, filter);
    } catch (const std::invalid_argument& refusal) {
        if (std::string(refusal.what()).rfind(asked, 0) != 0) Fail(asked, refusal.what());
    }
    return 0;
}
