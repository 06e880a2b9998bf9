// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/formula_renderer.h"

#include "model/files/file_io.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJSEngine>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLoggingCategory>
#include <QMutex>
#include <QStandardPaths>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <atomic>
#include <memory>
#include <optional>

// The bundle is in a static library; the macro that links it must stand outside all namespaces.
static void initMathJaxResource()
{
    Q_INIT_RESOURCE(mathjax);
}

namespace cradle {

namespace {

constexpr QLatin1String scriptPath(":/mathjax/mathjax.js");
constexpr QLatin1String versionPath(":/mathjax/version");

// MathJax recurses for nested formulas; the default of some systems (512 KiB) is too little.
constexpr uint stackBytes = 8U << 20U;

/// MathJax goes after so long without a formula, ms: a step's formulas are asked for together, and
/// loading it takes a third of a second.
constexpr int restTime = 2000;

/// The allocator keeps what another thread than the first has freed, unless it is told.
void returnFreeMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QLoggingCategory::CategoryFilter outerFilter = nullptr;

void silenceCompiler(QLoggingCategory *category)
{
    if (outerFilter)
        outerFilter(category);
    if (qstrcmp(category->categoryName(), "qt.qml.compiler") == 0)
        category->setEnabled(QtWarningMsg, false);
}

/// Evaluates the bundle without Qt's warnings of variables that a script, as this one rightly
/// does, names above their declaration.
QJSValue evaluateQuietly(QJSEngine &engine, const QByteArray &script)
{
    static QMutex oneAtATime; // the filter is global
    const QMutexLocker lock(&oneAtATime);
    outerFilter = QLoggingCategory::installFilter(silenceCompiler);
    const QJSValue result = engine.evaluate(QString::fromUtf8(script), scriptPath);
    QLoggingCategory::installFilter(outerFilter);
    outerFilter = nullptr;
    return result;
}

/// Reads an answer of texToSvg(); nullopt if it is not one, such as a damaged cache file.
std::optional<Formula> parseAnswer(const QByteArray &json)
{
    const QJsonObject answer = QJsonDocument::fromJson(json).object();
    Formula formula;
    formula.error = answer[u"error"].toString();
    if (!formula.error.isEmpty()) {
        formula.state = Formula::State::Broken;
        return formula;
    }
    formula.state = Formula::State::Ready;
    formula.svg = answer[u"svg"].toString().toUtf8();
    formula.width = answer[u"width_ex"].toDouble();
    formula.height = answer[u"height_ex"].toDouble();
    formula.depth = answer[u"depth_ex"].toDouble();
    const bool valid = !formula.svg.isEmpty() && formula.width > 0.0 && formula.height > 0.0;
    return valid ? std::optional(formula) : std::nullopt;
}

} // namespace

/// MathJax and the formulas on disk; every function but interrupt() runs on the worker thread.
class FormulaWorker final : public QObject
{
public:
    explicit FormulaWorker(const QString &cacheFolder)
        : m_cacheFolder(cacheFolder)
    {
    }

    Formula formula(const QString &tex, bool display)
    {
        if (m_interrupted)
            return {};
        if (!QFile::exists(scriptPath))
            return unavailable(FormulaRenderer::tr("Cradle was built without MathJax, so "
                                                   "formulas show as text."));

        const QString path = cachePath(tex, display);
        if (const auto kept = parseAnswer(contentOf(path)))
            return *kept;
        if (const QString failure = load(); !failure.isEmpty())
            return unavailable(failure);

        const QJSValue answer = m_texToSvg.call({tex, display});
        const QByteArray json = answer.toString().toUtf8();
        const auto formula = parseAnswer(json);
        if (answer.isError() || !formula)
            return {Formula::State::Broken, {}, 0.0, 0.0, 0.0, answer.toString()};
        keep(path, json);
        return *formula;
    }

    /// Lets MathJax go, until it is needed again.
    void unload()
    {
        QMutexLocker lock(&m_mutex);
        m_texToSvg = {};
        m_engine.reset();
        m_failure.clear();
        m_isLoaded = false;
        lock.unlock();
        returnFreeMemory();
    }

    /// From any thread.
    [[nodiscard]] bool isLoaded() const { return m_isLoaded; }

    /// Makes a formula in work, and all after it, end at once. From any thread.
    void interrupt()
    {
        const QMutexLocker lock(&m_mutex);
        m_interrupted = true;
        if (m_engine)
            m_engine->setInterrupted(true);
    }

private:
    static Formula unavailable(const QString &reason)
    {
        return {Formula::State::Unavailable, {}, 0.0, 0.0, 0.0, reason};
    }

    QString cachePath(const QString &tex, bool display) const
    {
        QCryptographicHash hash(QCryptographicHash::Sha1);
        hash.addData(contentOf(versionPath));
        hash.addData(display ? QByteArrayView("display\n") : QByteArrayView("inline\n"));
        hash.addData(tex.toUtf8());
        return m_cacheFolder + u'/' + QString::fromLatin1(hash.result().toHex())
               + QLatin1String(".json");
    }

    /// A formula that cannot be kept is drawn again next time: failure needs no message.
    void keep(const QString &path, const QByteArray &json) const
    {
        if (QDir().mkpath(m_cacheFolder))
            (void)writeFile(path, json);
    }

    /// Loads MathJax if that was not tried before. \return the reason of failure, or nothing
    QString load()
    {
        if (m_engine)
            return m_failure;
        QMutexLocker lock(&m_mutex);
        m_engine = std::make_unique<QJSEngine>();
        m_engine->setInterrupted(m_interrupted);
        m_isLoaded = true;
        lock.unlock();
        const QJSValue result = evaluateQuietly(*m_engine, contentOf(scriptPath));
        m_texToSvg = m_engine->globalObject().property(QStringLiteral("texToSvg"));
        if (result.isError() || !m_texToSvg.isCallable())
            m_failure = FormulaRenderer::tr("MathJax does not run: %1").arg(result.toString());
        return m_failure;
    }

    const QString m_cacheFolder;
    QString m_failure;
    QMutex m_mutex; ///< guards the birth and the end of m_engine
    std::atomic_bool m_isLoaded = false;
    std::atomic_bool m_interrupted = false;
    std::unique_ptr<QJSEngine> m_engine;
    QJSValue m_texToSvg; ///< after m_engine, so that it goes first
};

FormulaRenderer::FormulaRenderer(QObject *parent, const QString &cacheFolder)
    : QObject(parent)
{
    initMathJaxResource();
    const QString standard = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    m_worker = new FormulaWorker(cacheFolder.isEmpty() ? standard + QLatin1String("/formulas")
                                                       : cacheFolder);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    // The just-in-time compiler of Qt 6.4 crashes now and then when it runs on a second thread
    // (1 of 24 starts); the interpreter did not in 40.
    qputenv("QV4_FORCE_INTERPRETER", "1");
    m_thread.setObjectName(QStringLiteral("formulas"));
    m_thread.setStackSize(stackBytes);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restTime);
    connect(&m_rest, &QTimer::timeout, this, &FormulaRenderer::unload);
}

FormulaRenderer::~FormulaRenderer()
{
    if (!m_thread.isRunning()) {
        delete m_worker;
        return;
    }
    m_worker->interrupt();
    m_thread.quit();
    m_thread.wait();
}

void FormulaRenderer::request(const QString &tex, bool display)
{
    const Key key(tex, display);
    if (m_waiting.contains(key))
        return;
    m_waiting.insert(key);

    if (const Formula *formula = known(tex, display)) {
        const auto again = [this, key, copy = *formula] { finish(key, copy); };
        QMetaObject::invokeMethod(this, again, Qt::QueuedConnection);
        return;
    }
    if (!m_thread.isRunning())
        m_thread.start();
    const auto work = [this, worker = m_worker, key] {
        const Formula formula = worker->formula(key.first, key.second);
        // The renderer waits for this thread before it dies, and drops calls not yet made.
        QMetaObject::invokeMethod(
            this, [this, key, formula] { finish(key, formula); }, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(m_worker, work, Qt::QueuedConnection);
}

const Formula *FormulaRenderer::known(const QString &tex, bool display) const
{
    const auto found = m_known.constFind(Key(tex, display));
    return found == m_known.cend() ? nullptr : &*found;
}

void FormulaRenderer::finish(const Key &key, const Formula &formula)
{
    m_waiting.remove(key);
    m_known.insert(key, formula);
    if (m_waiting.isEmpty() && isLoaded())
        m_rest.start();
    emit ready(key.first, key.second, formula);
}

void FormulaRenderer::unload()
{
    if (isIdle())
        QMetaObject::invokeMethod(
            m_worker, [worker = m_worker] { worker->unload(); }, Qt::QueuedConnection);
}

bool FormulaRenderer::isLoaded() const
{
    return m_worker->isLoaded();
}

} // namespace cradle
