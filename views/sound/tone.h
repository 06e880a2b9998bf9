// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace cradle {

/// Samples a second of all sounds; one channel, from −1 to 1.
inline constexpr int sampleRate = 44100;

/// What a struck circle sounds like.
struct Tone {
    double frequency = 0.0; ///< Hz
    double amplitude = 0.0; ///< of its loudest sample, 0 to 1

    friend bool operator==(const Tone &, const Tone &) = default;
};

/// The tone of a circle of \p mass, kg, that is hit by \p impulse, N s. Bodies of one shape and
/// material ring the lower the larger they are, f ∝ m^(−1/3): a steel ball of 0.2 m sounds at 440
/// Hz, and tones stay within 110 and 3520 Hz. Twice the impulse is up to twice as loud; none is
/// louder than ½, so that circle and circle can sound together.
[[nodiscard]] Tone toneOf(double mass, double impulse);

/// The samples of \p tone: a sine that dies away within 0.4 s.
[[nodiscard]] std::vector<float> samplesOf(const Tone &tone);
/// The samples of all \p tones at once, cut at ±1.
[[nodiscard]] std::vector<float> samplesOf(std::span<const Tone> tones);

/// A curve as sound: \p values, in equal times, are played in 2 s from left to right, the least of
/// them at 220 Hz, the greatest at 880 Hz, and equal differences as equal intervals. Where all are
/// equal: 440 Hz. Values that are not finite are silent; none gives nothing.
[[nodiscard]] std::vector<float> samplesOfCurve(std::span<const double> values);

} // namespace cradle
