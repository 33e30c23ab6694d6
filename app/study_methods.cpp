// thetalane study throws, thetalane study SCENE
#include "app/console.h"
#include "app/save_file.h"
#include "app/studies.h"
#include "app/study_report.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QSysInfo>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

namespace thetalane {
namespace {

struct StudyMethodsText {
    Q_DECLARE_TR_FUNCTIONS(StudyMethodsText)
};

volatile std::sig_atomic_t interrupted = 0;

// Ctrl+C ends the study, not the program: what was measured by then is written, and says so.
class Interruption {
public:
    Interruption()
        : m_before(std::signal(SIGINT, [](int) { interrupted = 1; }))
        , m_watch([this](std::stop_token done) {
            while (!done.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                if (interrupted)
                    m_stop.request_stop();
            }
        }) {}
    ~Interruption() { std::signal(SIGINT, m_before); }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return m_stop.get_token(); }

private:
    std::stop_source m_stop;
    void (*m_before)(int);
    std::jthread m_watch;
};

void say(const QString& line) {
    const QByteArray bytes = (line + '\n').toUtf8();
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stderr);
}

// A line for each round of costs, and for errors one in a second.
class Teller {
public:
    void operator()(const StudyProgress& p) {
        const auto now = Clock::now();
        if (p.stage == StudyStage::Errors && p.done < p.total && now - m_last < std::chrono::seconds(1))
            return;
        if (p.stage == StudyStage::Cost && p.done == 0)
            return;
        m_last = now;
        switch (p.stage) {
        case StudyStage::Truth:
            return say(StudyMethodsText::tr("the truth …"));
        case StudyStage::Cost:
            return say(StudyMethodsText::tr("costs: round %1 of %2").arg(p.done).arg(p.total));
        case StudyStage::Errors:
            break;
        }
        say(StudyMethodsText::tr("errors: %1 of %2 cases").arg(p.done).arg(p.total));
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point m_last{};
};

StudyResult study(const StudyCases& cases, const StudyOptions& options, std::stop_token stop) {
    Teller teller;
    return runStudy(
        cases, options, [&](const StudyResult&, const StudyProgress& p) { teller(p); }, stop);
}

QString processorName() {
    QFile file("/proc/cpuinfo");
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith("model name"))
                return QString::fromUtf8(line.mid(line.indexOf(':') + 1)).simplified();
    return QSysInfo::currentCpuArchitecture();
}

} // namespace

StudyConditions conditionsNow(const QString& seed, const QString& call) {
    return {QDateTime::currentDateTimeUtc().toString(Qt::ISODate),
            QString("%1 · %2 threads · %3")
                .arg(processorName())
                .arg(std::thread::hardware_concurrency())
                .arg(QSysInfo::prettyProductName()),
            seed, call};
}

std::variant<int, StudyPicture> studyOfMethods(const MethodsCall& call) {
    for (const QString& path : {call.csv, call.picture}) // a study takes a minute
        if (const auto status = path.isEmpty() ? std::nullopt : cannotSave(path))
            return *status;

    const Interruption interruption;
    StudyResult result = study(call.cases, call.options, interruption.token());
    QList<const StudyResult*> results{&result};
    StudyResult models;
    const StudyOptions ablation = ablationStudy(call.cases.scenes.front());
    // The rule of ties alone says little about one scene.
    const bool worthIt = ablation.methods.size() > (call.throws ? 1 : 2);
    if (call.models && worthIt && !result.cancelled) {
        models = study(call.cases, ablation, interruption.token());
        results << &models;
    }
    if (!call.csv.isEmpty()) {
        const auto seed = call.throws ? QString::number(call.seed) : QString();
        const QByteArray csv = studyCsv(results, conditionsNow(seed, call.call)).toUtf8();
        if (const int status = saveFile(call.csv, csv); status != Done)
            return status;
    }
    printLine(call.title);
    printLine();
    printStudy(result, call.throws);
    if (results.size() > 1)
        printModels(models, call.throws);
    if (const int status = finishOutput(); status != Done)
        return status;
    if (result.cancelled || models.cancelled)
        return failure(StudyMethodsText::tr("cancelled; what was measured by then has been kept"));
    if (call.picture.isEmpty())
        return int(Done);
    return StudyPicture{std::move(result), call.title, call.throws, call.picture, call.language};
}

} // namespace thetalane
