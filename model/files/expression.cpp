// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/expression.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace cradle {

namespace {

struct ExpressionText {
    Q_DECLARE_TR_FUNCTIONS(Expression)
};

constexpr qsizetype longest = 400;
constexpr int deepest = 50; ///< parentheses inside each other

struct OfOne {
    const char *name;
    double (*of)(double);
};
constexpr OfOne ofOne[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"round", [](double x) { return std::round(x); }},
};

struct OfTwo {
    const char *name;
    double (*of)(double, double);
};
constexpr OfTwo ofTwo[] = {
    {"min", [](double x, double y) { return std::fmin(x, y); }},
    {"max", [](double x, double y) { return std::fmax(x, y); }},
    {"atan2", [](double x, double y) { return std::atan2(x, y); }},
};

/// Reads one expression; used once. The first fault ends it.
class Reader
{
public:
    Reader(const QString &text, const QMap<QString, double> &values)
        : m_text(text)
        , m_values(values)
    {
    }

    Result<double> read()
    {
        const double value = sum();
        skipSpace();
        if (m_fault.isEmpty() && m_at < m_text.size())
            fail(ExpressionText::tr("“%1” is not expected there").arg(m_text.mid(m_at, 12)));
        if (m_fault.isEmpty() && !std::isfinite(value))
            fail(ExpressionText::tr("it comes to no finite number"));
        if (m_fault.isEmpty())
            return value;
        return Error{.message =
                         ExpressionText::tr("“%1” is no number: %2").arg(m_text.left(60), m_fault)};
    }

private:
    double fail(const QString &fault)
    {
        if (m_fault.isEmpty())
            m_fault = fault;
        m_at = m_text.size();
        return 0.0;
    }

    void skipSpace()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }

    bool takes(char letter)
    {
        skipSpace();
        if (m_at >= m_text.size() || m_text[m_at] != QLatin1Char(letter))
            return false;
        ++m_at;
        return true;
    }

    double sum()
    {
        double value = product();
        for (;;) {
            if (takes('+'))
                value += product();
            else if (takes('-'))
                value -= product();
            else
                return value;
        }
    }

    double product()
    {
        double value = signedPower();
        for (;;) {
            if (takes('*'))
                value *= signedPower();
            else if (takes('/'))
                value /= signedPower();
            else
                return value;
        }
    }

    double signedPower()
    {
        if (++m_depth > deepest)
            return fail(ExpressionText::tr("it is too deep"));
        double value = 0.0;
        if (takes('-')) {
            value = -signedPower();
        } else if (takes('+')) {
            value = signedPower();
        } else {
            value = atom();
            if (takes('^'))
                value = std::pow(value, signedPower());
        }
        --m_depth;
        return value;
    }

    double atom()
    {
        skipSpace();
        if (takes('(')) {
            const double value = sum();
            return takes(')') ? value
                              : fail(ExpressionText::tr("a closing parenthesis is missing"));
        }
        static const QRegularExpression number(
            QStringLiteral("\\G(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?"));
        static const QRegularExpression word(QStringLiteral("\\G[A-Za-z][A-Za-z0-9_]*"));
        if (const auto match = number.match(m_text, m_at); match.hasMatch()) {
            m_at = match.capturedEnd();
            return match.captured().toDouble();
        }
        if (const auto match = word.match(m_text, m_at); match.hasMatch()) {
            m_at = match.capturedEnd();
            return named(match.captured());
        }
        return fail(m_at < m_text.size()
                        ? ExpressionText::tr("“%1” is not expected there").arg(m_text.mid(m_at, 12))
                        : ExpressionText::tr("something is missing at its end"));
    }

    double named(const QString &name)
    {
        for (const OfOne &each : ofOne) {
            if (name == QLatin1String(each.name))
                return takes('(') ? each.of(arguments(1).front()) : noArguments(name);
        }
        for (const OfTwo &each : ofTwo) {
            if (name != QLatin1String(each.name))
                continue;
            if (!takes('('))
                return noArguments(name);
            const std::vector<double> two = arguments(2);
            return each.of(two[0], two[1]);
        }
        if (name == QLatin1String("pi"))
            return std::numbers::pi;
        const auto value = m_values.constFind(name);
        return value != m_values.constEnd()
                   ? *value
                   : fail(ExpressionText::tr("there is no value called %1").arg(name));
    }

    double noArguments(const QString &name)
    {
        return fail(ExpressionText::tr("a parenthesis behind %1 is missing").arg(name));
    }

    std::vector<double> arguments(int count)
    {
        std::vector<double> values;
        for (int i = 0; i < count; ++i) {
            if (i > 0 && !takes(','))
                fail(ExpressionText::tr("a comma and another number are missing"));
            values.push_back(sum());
        }
        if (!takes(')'))
            fail(ExpressionText::tr("a closing parenthesis is missing"));
        return values;
    }

    QString m_text;
    const QMap<QString, double> &m_values;
    qsizetype m_at = 0;
    int m_depth = 0;
    QString m_fault{};
};

} // namespace

Result<double> evaluated(const QString &text, const QMap<QString, double> &values)
{
    if (text.size() > longest)
        return Error{
            .message =
                ExpressionText::tr("an expression of at most %1 characters is right").arg(longest)};
    QString plain = text;
    plain.replace(QChar(0x2212), QLatin1Char('-')); // minus sign
    plain.replace(QChar(0x2044), QLatin1Char('/')); // fraction slash
    plain.replace(QChar(0x00B7), QLatin1Char('*')); // middle dot
    return Reader(plain, values).read();
}

bool isValueName(const QString &name)
{
    static const QRegularExpression form(QStringLiteral("^[A-Za-z][A-Za-z0-9_]{0,31}$"));
    if (!form.match(name).hasMatch() || name == QLatin1String("pi"))
        return false;
    for (const OfOne &each : ofOne) {
        if (name == QLatin1String(each.name))
            return false;
    }
    for (const OfTwo &each : ofTwo) {
        if (name == QLatin1String(each.name))
            return false;
    }
    return true;
}

} // namespace cradle
