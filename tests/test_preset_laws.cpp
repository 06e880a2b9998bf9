// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model/files/preset_json.h"
#include "tests/generators.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Any double of either sign and any size up to \p bound, zeros and tiny ones among them.
double wildNumber(double bound)
{
    const double mantissa = numberIn(-1.0, 1.0);
    return std::clamp(std::ldexp(mantissa, *rc::gen::inRange(-1080, 40)), -bound, bound);
}

double positiveNumber(double low, double high)
{
    return std::clamp(std::abs(wildNumber(high)), low, high);
}

QString anyName()
{
    std::u32string name;
    for (const std::uint32_t code : *rc::gen::container<std::vector<std::uint32_t>>(
             rc::gen::inRange<std::uint32_t>(1, 0x10ffff))) {
        if (name.size() < 100 && (code < 0xd800 || code > 0xdfff))
            name.push_back(static_cast<char32_t>(code));
    }
    return QString::fromStdU32String(name);
}

} // namespace

/// Any scene round-trips through its file, and any bytes are read or refused.
class TestPresetLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void presetsRoundTrip();
    void fillsRoundTrip();
    void anyBytesAreReadOrRefused();
};

void TestPresetLaws::initTestCase()
{
    useFixedCases();
}

void TestPresetLaws::presetsRoundTrip()
{
    QVERIFY(rc::check("read what was written, write it again", [] {
        Preset preset;
        preset.name = anyName();
        preset.halfWidth = positiveNumber(limits::minLength, limits::maxLength);
        preset.gravity = {wildNumber(limits::maxAcceleration), wildNumber(limits::maxAcceleration)};
        preset.restitution = positiveNumber(0.0, 1.0);
        preset.timestep = positiveNumber(limits::minTimestep, limits::maxTimestep);
        preset.laws.timing = *rc::gen::element(Timing::Discrete, Timing::Continuous, Timing::Exact);
        // With a law they must not overlap: then they stand in a row, far apart.
        preset.laws.circles =
            *rc::gen::element(CircleLaw::None, CircleLaw::Stop, CircleLaw::SwapVelocities,
                              CircleLaw::SwapNormal, CircleLaw::Impulse);
        const bool apart = preset.laws.circles != CircleLaw::None;
        const int count = *rc::gen::inRange(0, 6);
        for (int i = 0; i < count; ++i) {
            PresetCircle c;
            c.name = anyName();
            c.body.radius = positiveNumber(limits::minLength, apart ? 1.0 : limits::maxLength);
            c.body.density = positiveNumber(limits::minDensity, limits::maxDensity);
            c.body.velocity = {wildNumber(limits::maxSpeed), wildNumber(limits::maxSpeed)};
            c.body.position = {apart ? 4.0 * i + numberIn(-0.5, 0.5)
                                     : wildNumber(limits::maxLength),
                               wildNumber(limits::maxLength)};
            c.integrator = anyIntegrator();
            c.colour =
                QStringLiteral("#%1").arg(*rc::gen::inRange(0, 0x1000000), 6, 16, QLatin1Char('0'));
            preset.circles.push_back(c);
        }
        RC_ASSERT(!findFault(preset).has_value());
        const QByteArray written = writePreset(preset);
        const Result<Preset> read = parsePreset(written);
        if (!read)
            RC_FAIL(read.error().toString().toStdString());
        RC_ASSERT(*read == preset);
        RC_ASSERT(writePreset(*read) == written);
    }));
}

void TestPresetLaws::fillsRoundTrip()
{
    QVERIFY(rc::check("the fill and its circles", [] {
        Preset preset;
        preset.halfWidth = numberIn(1.0, 10.0);
        preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
        preset.fill = CircleFill{.count = *rc::gen::inRange(1, 60),
                                 .radius = numberIn(0.001, 0.1),
                                 .rmsSpeed = numberIn(0.0, 10.0),
                                 .density = numberIn(0.1, 10.0),
                                 .seed = *rc::gen::inRange(0, 2147483647)};
        preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
        RC_ASSERT(!findFault(preset).has_value());
        const QByteArray written = writePreset(preset);
        const Result<Preset> read = parsePreset(written);
        RC_ASSERT(read.ok());
        RC_ASSERT(*read == preset);
        RC_ASSERT(writePreset(*read) == written);
    }));
}

void TestPresetLaws::anyBytesAreReadOrRefused()
{
    QVERIFY(rc::check("no crash, and a message", [] {
        QByteArray text = writePreset(scene({circle({0, 0}), circle({1, 0})}, {}));
        const int changes = *rc::gen::inRange(1, 6);
        for (int i = 0; i < changes; ++i)
            text[*rc::gen::inRange(0, static_cast<int>(text.size()))] =
                static_cast<char>(*rc::gen::inRange(-128, 128));
        const Result<Preset> preset = parsePreset(text);
        if (preset)
            RC_ASSERT(!findFault(*preset).has_value());
        else
            RC_ASSERT(!preset.error().message.isEmpty());
    }));
}

QTEST_GUILESS_MAIN(TestPresetLaws)
#include "test_preset_laws.moc"
