#include "ui/words/game_text.h"

#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

struct GameText {
    Q_DECLARE_TR_FUNCTIONS(GameText)
};

QString whatIsWrong(const GameFileError& e) {
    const QString value = exactText(e.value), high = exactText(e.high);
    switch (e.fault) {
    case GameFileFault::WrongFormat:
        return GameText::tr("must be \"thetalane-game\", is \"%1\"").arg(QString::fromStdString(e.text));
    case GameFileFault::WrongVersion:
        return GameText::tr("must be 1, is %1; a newer program wrote this game").arg(value);
    case GameFileFault::WrongRules:
        return GameText::tr("must be \"traditional\" or \"current-frame\", is \"%1\"")
            .arg(QString::fromStdString(e.text));
    case GameFileFault::PlayerCount:
        return GameText::tr("must be 1 to %1 players, are %2").arg(high, value);
    case GameFileFault::NoName:
        return GameText::tr("must not be empty");
    case GameFileFault::Colour:
        return GameText::tr("must be a whole number from 0 to %1, is %2").arg(high, value);
    case GameFileFault::NotABool:
        return GameText::tr("must be true or false");
    case GameFileFault::NotWhole:
        return GameText::tr("must be a whole number, is %1").arg(value);
    case GameFileFault::PinNumber:
        return GameText::tr("must be the number of a pin, 1 to %1").arg(high);
    case GameFileFault::PinTwice:
        return GameText::tr("pin %1 is in the list already").arg(value);
    case GameFileFault::CountDiffers:
        return GameText::tr("must be %1, as many as \"down\" names, is %2").arg(high, value);
    case GameFileFault::TooManyPins:
        return GameText::tr("must be from 0 to %1, the pins that stand, is %2").arg(high, value);
    case GameFileFault::NegativePins:
        return GameText::tr("must not be less than 0, is %1").arg(value);
    case GameFileFault::PinNotStanding:
        return GameText::tr("pin %1 is down already").arg(value);
    case GameFileFault::GameOver:
        return GameText::tr("is one delivery too many; the game is over before");
    case GameFileFault::NotMet:
        return GameText::tr("must be the pins that the deliveries before left standing");
    case GameFileFault::OutOfTurn:
        return GameText::tr("goes into frame %1; by the turns of the others it can be at most frame %2")
            .arg(value, high);
    case GameFileFault::Shape:
        break;
    }
    return {};
}

} // namespace

QString deliveryErrorMessage(const DeliveryError& e) {
    switch (e.fault) {
    case DeliveryFault::NegativePins:
        return GameText::tr("%1 pins cannot fall").arg(e.pins);
    case DeliveryFault::MoreThanStand:
        return GameText::tr("only %1 pins stand, not %2").arg(e.turn.standing).arg(e.pins);
    case DeliveryFault::PinNotStanding:
        return GameText::tr("pin %1 is down already").arg(e.pins);
    case DeliveryFault::CountDiffers:
        return GameText::tr("the count and the pins chosen do not agree");
    case DeliveryFault::GameOver:
        break;
    }
    return GameText::tr("this delivery is one too many");
}

QString gameErrorMessage(const GameError& e) {
    switch (e.fault) {
    case GameFault::WrongDelivery:
        return deliveryErrorMessage(e.delivery);
    case GameFault::NoSuchFrame:
        return GameText::tr("this frame has not been played");
    case GameFault::FrameLeftOpen:
        return GameText::tr("a delivery is missing in this frame");
    case GameFault::GameOver:
        break;
    }
    return GameText::tr("the game is over");
}

QString gameFileErrorText(const GameFileError& e) {
    if (e.fault == GameFileFault::Shape)
        return sceneErrorText(e.scene);
    return QString::fromStdString(e.path) + ": " + whatIsWrong(e);
}

} // namespace thetalane
