// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"

#include <cstdio>
#include <cstdlib>

using namespace cradle;

namespace {

/// Circles of a preset that is written and read again; larger fills would only take their time.
constexpr std::size_t fewCircles = 2000;

/// Ends the process, which the fuzzer takes for a find and keeps the input of.
void demand(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "not so: %s\n", what);
    std::abort();
}

} // namespace

/// libFuzzer's entry: any bytes are a preset or are refused with a reason. What is read can be
/// run, and is the same when it is written and read again.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const QByteArray text(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const Result<Preset> preset = parsePreset(text);
    if (!preset) {
        demand(!preset.error().message.isEmpty(), "a refusal has a message");
        return 0;
    }
    demand(!findFault(*preset).has_value(), "what was read can be run");
    if (preset->circles.size() > fewCircles)
        return 0;
    const QByteArray written = writePreset(*preset);
    const Result<Preset> again = parsePreset(written);
    demand(again.ok(), "what was written can be read");
    demand(*again == *preset, "it is the same preset");
    demand(writePreset(*again) == written, "and is written the same");
    return 0;
}
