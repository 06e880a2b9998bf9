// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sound/tone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace cradle {

namespace {

constexpr double standardMass = 261.38;     ///< kg: a steel ball of radius 0.2 m
constexpr double standardFrequency = 440.0; ///< Hz, of that
constexpr double lowest = 110.0;            ///< Hz
constexpr double highest = 3520.0;          ///< Hz
constexpr double halfImpulse = 500.0;       ///< N s: half as loud as can be
constexpr double loudest = 0.5;
constexpr double duration = 0.4;   ///< s
constexpr double decay = 0.08;     ///< s to 1/e
constexpr double attack = 0.002;   ///< s; without it every tone would click
constexpr double curveTime = 2.0;  ///< s
constexpr double curveLow = 220.0; ///< Hz
constexpr double octaves = 2.0;    ///< from the least to the greatest value
constexpr double curveAmplitude = 0.3;
constexpr double turn = 2.0 * std::numbers::pi;

std::size_t samplesIn(double seconds)
{
    return static_cast<std::size_t>(seconds * sampleRate);
}

} // namespace

Tone toneOf(double mass, double impulse)
{
    const double size = std::cbrt(mass / standardMass);
    const double force = std::abs(impulse);
    return {.frequency = std::clamp(standardFrequency / size, lowest, highest),
            .amplitude = loudest * force / (force + halfImpulse)};
}

std::vector<float> samplesOf(const Tone &tone)
{
    std::vector<float> samples(samplesIn(duration));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = static_cast<double>(i) / sampleRate;
        const double envelope = std::min(t / attack, 1.0) * std::exp(-t / decay);
        samples[i] =
            static_cast<float>(tone.amplitude * envelope * std::sin(turn * tone.frequency * t));
    }
    return samples;
}

std::vector<float> samplesOf(std::span<const Tone> tones)
{
    std::vector<float> all;
    for (const Tone &tone : tones) {
        const std::vector<float> one = samplesOf(tone);
        all.resize(std::max(all.size(), one.size()));
        for (std::size_t i = 0; i < one.size(); ++i)
            all[i] += one[i];
    }
    for (float &sample : all)
        sample = std::clamp(sample, -1.0F, 1.0F);
    return all;
}

std::vector<float> samplesOfCurve(std::span<const double> values)
{
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const double value : values) {
        if (std::isfinite(value)) {
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        }
    }
    if (!(least <= greatest))
        return {};
    std::vector<float> samples(samplesIn(curveTime));
    double phase = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double value = values[i * values.size() / samples.size()];
        if (!std::isfinite(value))
            continue;
        const double height = least < greatest ? (value - least) / (greatest - least) : 0.5;
        phase += turn * curveLow * std::exp2(octaves * height) / sampleRate;
        samples[i] = static_cast<float>(curveAmplitude * std::sin(phase));
    }
    return samples;
}

} // namespace cradle
