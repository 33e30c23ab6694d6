<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>BodyName</name>
    <message>
        <source>ball</source>
        <translation>공</translation>
    </message>
    <message>
        <source>cue</source>
        <translation>수구</translation>
    </message>
</context>
<context>
    <name>CollisionSheet</name>
    <message>
        <source>Σ%1 after − before</source>
        <translation>Σ%1의 변화 (후 − 전)</translation>
    </message>
    <message>
        <source>within rounding</source>
        <translation>반올림 오차 이내</translation>
    </message>
    <message>
        <source>taken up by the wall</source>
        <translation>벽이 받은 몫</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>합계</translation>
    </message>
    <message>
        <source>After</source>
        <translation>충돌 후</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
    <message>
        <source>−(relative velocity along x′ after)/(before) = %1</source>
        <translation>−(충돌 후 x′ 상대 속도)/(충돌 전 x′ 상대 속도) = %1</translation>
    </message>
    <message>
        <source>e from the velocities</source>
        <translation>속도로 구한 e</translation>
    </message>
    <message>
        <source>given: %1</source>
        <translation>주어진 값: %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>after</source>
        <translation>충돌 후</translation>
    </message>
    <message>
        <source>e, given</source>
        <translation>주어진 e</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>lists the built-in scenes: name, title</source>
        <translation>내장 장면의 이름과 제목을 나열합니다</translation>
    </message>
    <message>
        <source>prints a built-in scene as a scene file, to edit</source>
        <translation>내장 장면을 고쳐 쓸 수 있는 장면 파일로 출력합니다</translation>
    </message>
    <message>
        <source>simulates a scene: a table of collisions and totals, JSON or CSV</source>
        <translation>장면을 시뮬레이션하여 충돌 표와 합계, 또는 JSON이나 CSV를 출력합니다</translation>
    </message>
    <message>
        <source>works through one collision, step by step, with its numbers substituted</source>
        <translation>충돌 하나를 수를 대입하며 단계별로 풀이합니다</translation>
    </message>
    <message>
        <source>throws one ball down the regulation lane at a full rack</source>
        <translation>규격 레인에서 핀 열 개를 향해 공을 한 번 던집니다</translation>
    </message>
    <message>
        <source>draws the window, as it would look, into a PNG file</source>
        <translation>창의 모습을 PNG 파일로 그립니다</translation>
    </message>
    <message>
        <source>scores a game of ten-pin bowling: frames and totals</source>
        <translation>텐핀 볼링 한 게임의 점수를 계산합니다: 프레임별 점수와 누계</translation>
    </message>
    <message>
        <source>the strike map: pins down over offset and entry angle</source>
        <translation>스트라이크 지도: 위치와 입사각에 따라 쓰러지는 핀의 수</translation>
    </message>
    <message>
        <source>measures speed against accuracy, method by method, and what is made of extremes</source>
        <translation>방법마다 속도와 정확도를 재어 견주고, 극단적인 조건에서 얻는 값을 잽니다</translation>
    </message>
    <message>
        <source>a collision to work through by hand, with an answer page, as a PDF file to print</source>
        <translation>충돌 하나를 손으로 풀어 보는 활동지를 정답 쪽과 함께 인쇄용 PDF 파일로 만듭니다</translation>
    </message>
</context>
<context>
    <name>Console</name>
    <message>
        <source>standard output: cannot be written: %1</source>
        <translation>표준 출력: 쓸 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>Deed</name>
    <message>
        <source>move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>%1의 속도 변경</translation>
    </message>
    <message>
        <source>mass of %1</source>
        <translation>%1의 질량 변경</translation>
    </message>
    <message>
        <source>radius of %1</source>
        <translation>%1의 반지름 변경</translation>
    </message>
    <message>
        <source>kind of %1</source>
        <translation>%1의 종류 변경</translation>
    </message>
    <message>
        <source>name of %1</source>
        <translation>%1의 이름 변경</translation>
    </message>
    <message>
        <source>spin of %1</source>
        <translation>%1의 회전 변경</translation>
    </message>
    <message>
        <source>moment of inertia of %1</source>
        <translation>%1의 관성 모멘트 변경</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 삭제</translation>
    </message>
    <message>
        <source>mass of the ball</source>
        <translation>공의 질량 변경</translation>
    </message>
    <message>
        <source>speed of the throw</source>
        <translation>투구 속력 변경</translation>
    </message>
    <message>
        <source>direction of the throw</source>
        <translation>투구 방향 변경</translation>
    </message>
    <message>
        <source>position of the ball</source>
        <translation>공의 위치 변경</translation>
    </message>
    <message>
        <source>spin of the ball</source>
        <translation>공의 회전 변경</translation>
    </message>
    <message>
        <source>change the throw</source>
        <translation>투구 변경</translation>
    </message>
    <message>
        <source>pins that stand</source>
        <translation>서 있는 핀 변경</translation>
    </message>
    <message>
        <source>friction of the lane</source>
        <translation>레인 마찰 변경</translation>
    </message>
    <message>
        <source>arrange the bodies</source>
        <translation>물체 배치</translation>
    </message>
    <message>
        <source>coefficient of restitution</source>
        <translation>반발 계수 변경</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>벽 변경</translation>
    </message>
    <message>
        <source>coefficient of restitution of the walls</source>
        <translation>벽의 반발 계수 변경</translation>
    </message>
    <message>
        <source>title of the scene</source>
        <translation>장면 제목 변경</translation>
    </message>
    <message>
        <source>reset the scene</source>
        <translation>장면을 처음으로 되돌리기</translation>
    </message>
    <message>
        <source>open another scene</source>
        <translation>다른 장면 열기</translation>
    </message>
    <message>
        <source>edit the scene</source>
        <translation>장면 편집</translation>
    </message>
</context>
<context>
    <name>EngineChoiceText</name>
    <message>
        <source>%1 is the cheapest that stays within %2</source>
        <translation>오차 %2 안에 드는 방법 가운데 가장 빠른 것: %1</translation>
    </message>
    <message>
        <source>nothing stays within %2; %1 comes nearest</source>
        <translation>오차 %2 안에 드는 방법이 없습니다. 가장 가까운 것: %1</translation>
    </message>
    <message>
        <source>%1: about %2, too dear to be tried</source>
        <translation>%1: 약 %2, 너무 오래 걸려 재지 않음</translation>
    </message>
    <message>
        <source>%1: %2, off by at most %3</source>
        <translation>%1: %2, 가장 큰 오차 %3</translation>
    </message>
    <message>
        <source>measured until %1 s against %2, in %3 s</source>
        <translation>%1 s까지 %2 계산을 기준으로 쟀습니다. 걸린 시간 %3 s</translation>
    </message>
    <message>
        <source>too many bodies for 113 bits: what is measured is the distance from the next-event engine in double</source>
        <translation>물체가 너무 많아 113비트로는 계산하지 않았습니다. 잰 값은 배정밀도 정확한 계산과의 차이입니다</translation>
    </message>
    <message>
        <source>with --engine auto: the cheapest engine, step and precision that keeps every body within so many metres of where it should be, found by measuring them on this scene</source>
        <translation>--engine auto와 함께: 모든 물체의 위치 오차가 이 값[m] 안에 드는 가장 빠른 엔진과 시간 간격, 정밀도를 이 장면에서 재어 고름</translation>
    </message>
    <message>
        <source>only with --engine auto; choose it, or leave this out</source>
        <translation>--engine auto에서만 쓸 수 있습니다. 그 엔진을 고르거나 이 옵션을 빼십시오</translation>
    </message>
    <message>
        <source>is chosen by --tolerance; leave one of the two out</source>
        <translation>--tolerance가 고르는 값입니다. 둘 중 하나를 빼십시오</translation>
    </message>
    <message>
        <source>not until %1 s, which would have taken too long or have left too few digits: what comes later was not measured, so %2 was asked for</source>
        <translation>%1 s까지는 너무 오래 걸리거나 유효 숫자가 모자라 재지 않았습니다. 그 뒤의 오차를 알 수 없으므로 %2 안에 드는 것만 골랐습니다</translation>
    </message>
</context>
<context>
    <name>EngineOptionsText</name>
    <message>
        <source>the time to run [s]; 10 unless said</source>
        <translation>시뮬레이션할 시간 [s]. 기본값 10</translation>
    </message>
    <message>
        <source>ends the run after N collisions; 1000000 unless said</source>
        <translation>충돌이 N번 일어나면 끝냅니다. 기본값 1000000</translation>
    </message>
    <message>
        <source>stepped: exchanges only when the two approach</source>
        <translation>stepped: 두 물체가 서로 다가갈 때만 충돌로 처리합니다</translation>
    </message>
    <message>
        <source>the engine&apos;s numbers; double unless said</source>
        <translation>계산에 쓸 수의 정밀도. 기본값 double</translation>
    </message>
    <message>
        <source>bodies that friction presses together stay in touch when they would meet again sooner [s]; 0.0001 unless said</source>
        <translation>마찰이 맞누르는 두 물체가 이 시간 안에 다시 닿게 되면 붙은 채로 둡니다 [s]. 기본값 0.0001</translation>
    </message>
    <message>
        <source>only with --engine %1; choose it, or leave this out</source>
        <translation>--engine %1에서만 쓸 수 있습니다. 그 엔진을 고르거나 이 옵션을 빼십시오</translation>
    </message>
    <message>
        <source>must be at most %1, is %2</source>
        <translation>%1 이하여야 합니다. 입력한 값: %2</translation>
    </message>
    <message>
        <source>event: from contact to contact; swept: by steps, with the instant of each contact within a step; stepped: the paper&apos;s loop; auto: event</source>
        <translation>event: 다음 충돌의 시각을 바로 계산, swept: 일정한 시간 간격으로 나아가되 그 안에서 충돌하는 순간을 계산, stepped: 논문의 반복 계산, auto: event와 같음</translation>
    </message>
    <message>
        <source>the step of the stepped and swept engines [s]; 1/60 unless said</source>
        <translation>stepped 엔진과 swept 엔진의 시간 간격 [s]. 기본값 1/60</translation>
    </message>
    <message>
        <source>swept: how often within a step a body is looked at for what it hits next; 1 unless said</source>
        <translation>swept: 한 시간 간격 안에서 물체마다 다음 충돌을 찾아보는 횟수. 기본값 1</translation>
    </message>
    <message>
        <source>event: takes contacts of one instant one at a time, not together</source>
        <translation>event: 같은 순간의 접촉을 함께 계산하지 않고 하나씩 차례로 계산합니다</translation>
    </message>
</context>
<context>
    <name>ExplainCommandText</name>
    <message>
        <source>Collision %1: %2, at %3 s</source>
        <translation>충돌 %1: %2, 시각 %3 s</translation>
    </message>
    <message>
        <source>%1: nothing collides in this scene in the time asked for</source>
        <translation>%1: 이 장면에서는 지정한 시간 안에 충돌이 일어나지 않습니다</translation>
    </message>
    <message>
        <source>must be from 1 to %1, the number of collisions, is %2</source>
        <translation>1부터 충돌 횟수 %1까지여야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>which collision, from 1; the first unless said</source>
        <translation>몇 번째 충돌인지 (1부터). 기본값은 첫 번째</translation>
    </message>
</context>
<context>
    <name>GameText</name>
    <message>
        <source>must be &quot;thetalane-game&quot;, is &quot;%1&quot;</source>
        <translation>&quot;thetalane-game&quot;이어야 합니다. 적힌 값: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>must be 1, is %1; a newer program wrote this game</source>
        <translation>1이어야 합니다. 적힌 값: %1. 더 새로운 프로그램이 저장한 게임입니다</translation>
    </message>
    <message>
        <source>must be &quot;traditional&quot; or &quot;current-frame&quot;, is &quot;%1&quot;</source>
        <translation>&quot;traditional&quot;이나 &quot;current-frame&quot;이어야 합니다. 적힌 값: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>must be 1 to %1 players, are %2</source>
        <translation>참가자는 1명에서 %1명까지여야 합니다. 적힌 수: %2</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>비어 있으면 안 됩니다</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to %1, is %2</source>
        <translation>0부터 %1까지의 정수여야 합니다. 적힌 값: %2</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>true나 false여야 합니다</translation>
    </message>
    <message>
        <source>must be a whole number, is %1</source>
        <translation>정수여야 합니다. 적힌 값: %1</translation>
    </message>
    <message>
        <source>must be the number of a pin, 1 to %1</source>
        <translation>1부터 %1까지의 핀 번호여야 합니다</translation>
    </message>
    <message>
        <source>pin %1 is in the list already</source>
        <translation>%1번 핀이 목록에 이미 있습니다</translation>
    </message>
    <message>
        <source>must be %1, as many as &quot;down&quot; names, is %2</source>
        <translation>&quot;down&quot;에 적힌 핀의 수인 %1이어야 합니다. 적힌 값: %2</translation>
    </message>
    <message>
        <source>must be from 0 to %1, the pins that stand, is %2</source>
        <translation>0 이상이고 서 있는 핀의 수 %1 이하여야 합니다. 적힌 값: %2</translation>
    </message>
    <message>
        <source>must not be less than 0, is %1</source>
        <translation>0보다 작을 수 없습니다. 적힌 값: %1</translation>
    </message>
    <message>
        <source>pin %1 is down already</source>
        <translation>%1번 핀은 이미 쓰러져 있습니다</translation>
    </message>
    <message>
        <source>is one delivery too many; the game is over before</source>
        <translation>게임이 끝난 뒤의 투구입니다</translation>
    </message>
    <message>
        <source>must be the pins that the deliveries before left standing</source>
        <translation>앞의 투구가 남긴 핀과 같아야 합니다</translation>
    </message>
    <message>
        <source>goes into frame %1; by the turns of the others it can be at most frame %2</source>
        <translation>%1프레임까지 적혀 있습니다. 다른 참가자의 차례에 맞추면 %2프레임까지만 던질 수 있습니다</translation>
    </message>
    <message>
        <source>%1 pins cannot fall</source>
        <translation>핀 %1개가 쓰러질 수는 없습니다</translation>
    </message>
    <message>
        <source>only %1 pins stand, not %2</source>
        <translation>서 있는 핀은 %1개뿐입니다. 입력한 수: %2</translation>
    </message>
    <message>
        <source>the count and the pins chosen do not agree</source>
        <translation>핀의 수와 고른 핀이 서로 맞지 않습니다</translation>
    </message>
    <message>
        <source>this delivery is one too many</source>
        <translation>이 투구는 더 던질 수 없는 투구입니다</translation>
    </message>
    <message>
        <source>this frame has not been played</source>
        <translation>아직 던지지 않은 프레임입니다</translation>
    </message>
    <message>
        <source>a delivery is missing in this frame</source>
        <translation>이 프레임에 투구가 빠져 있습니다</translation>
    </message>
    <message>
        <source>the game is over</source>
        <translation>게임이 끝났습니다</translation>
    </message>
</context>
<context>
    <name>GameWords</name>
    <message>
        <source>Strike!</source>
        <translation>스트라이크!</translation>
    </message>
    <message>
        <source>Double!</source>
        <translation>더블!</translation>
    </message>
    <message>
        <source>Turkey!</source>
        <translation>터키!</translation>
    </message>
    <message>
        <source>%1 strikes in a row!</source>
        <translation>%1연속 스트라이크!</translation>
    </message>
    <message>
        <source>foul</source>
        <translation>파울</translation>
    </message>
    <message>
        <source>strike</source>
        <translation>스트라이크</translation>
    </message>
    <message>
        <source>spare</source>
        <translation>스페어</translation>
    </message>
    <message>
        <source>%1 (split)</source>
        <translation>%1 (스플릿)</translation>
    </message>
    <message>
        <source>Traditional scoring</source>
        <translation>전통 방식</translation>
    </message>
    <message>
        <source>Current-frame scoring</source>
        <translation>커런트 프레임 방식</translation>
    </message>
    <message>
        <source>Steady hand</source>
        <translation>안정된 손</translation>
    </message>
    <message>
        <source>League player</source>
        <translation>동호인</translation>
    </message>
    <message>
        <source>Beginner</source>
        <translation>초보자</translation>
    </message>
    <message>
        <source>Exactly as aimed</source>
        <translation>조준한 그대로</translation>
    </message>
    <message>
        <source>The ball is thrown exactly as it is aimed.</source>
        <translation>공을 조준한 그대로 던집니다.</translation>
    </message>
    <message>
        <source>The ball leaves the hand by chance a little otherwise than aimed. Standard deviations (guesses): speed %1 m/s, direction %2°, position %3 cm, rotation %4 %.</source>
        <translation>공이 손을 떠날 때 조준과 조금씩 우연히 어긋납니다. 표준 편차(추정값): 속력 %1 m/s, 방향 %2°, 위치 %3 cm, 회전 %4 %.</translation>
    </message>
    <message>
        <source>No friction</source>
        <translation>마찰 없음</translation>
    </message>
    <message>
        <source>Dry lane</source>
        <translation>오일 없는 레인</translation>
    </message>
    <message>
        <source>House oil</source>
        <translation>하우스 오일</translation>
    </message>
    <message>
        <source>All ten pins stand</source>
        <translation>핀 10개가 모두 서 있음</translation>
    </message>
    <message>
        <source>No pins stand</source>
        <translation>서 있는 핀 없음</translation>
    </message>
    <message>
        <source>Pin %1 stands</source>
        <translation>%1번 핀이 서 있음</translation>
    </message>
    <message>
        <source>Pins %1 stand</source>
        <translation>%1번 핀이 서 있음</translation>
    </message>
    <message>
        <source>%1 split</source>
        <translation>%1 스플릿</translation>
    </message>
    <message>
        <source>Perfect game! 300</source>
        <translation>퍼펙트 게임! 300</translation>
    </message>
    <message>
        <source>Perfect game!</source>
        <translation>퍼펙트 게임!</translation>
    </message>
    <message>
        <source>Foul</source>
        <translation>파울</translation>
    </message>
    <message>
        <source>Spare!</source>
        <translation>스페어!</translation>
    </message>
    <message>
        <source>Gutter ball</source>
        <translation>거터 볼</translation>
    </message>
    <message>
        <source>Open frame</source>
        <translation>오픈 프레임</translation>
    </message>
    <message>
        <source>No pins</source>
        <translation>쓰러진 핀 없음</translation>
    </message>
    <message>
        <source>Pins down: %1</source>
        <translation>쓰러진 핀 %1개</translation>
    </message>
    <message>
        <source>The pins do not count and are set up again.</source>
        <translation>쓰러진 핀은 점수에 들지 않고 다시 세웁니다.</translation>
    </message>
    <message>
        <source>%1 picked up.</source>
        <translation>%1 처리.</translation>
    </message>
    <message>
        <source>The game is over with %1 points.</source>
        <translation>게임이 %1점으로 끝났습니다.</translation>
    </message>
    <message>
        <source>%1 wins with %2 points.</source>
        <translation>%1 님이 %2점으로 이겼습니다.</translation>
    </message>
    <message>
        <source>A tie at %2 points: %1.</source>
        <translation>%2점으로 비겼습니다: %1.</translation>
    </message>
    <message>
        <source>Frame %1, ball %2</source>
        <translation>%1프레임 %2구</translation>
    </message>
    <message>
        <source>%1, frame %2, ball %3: %4</source>
        <translation>%1, %2프레임 %3구: %4</translation>
    </message>
    <message>
        <source>%1, frame %2: not played</source>
        <translation>%1, %2프레임: 아직 치지 않음</translation>
    </message>
    <message>
        <source>%1, frame %2: %3.</source>
        <translation>%1, %2프레임: %3.</translation>
    </message>
    <message>
        <source>Total %1.</source>
        <translation>누계 %1점.</translation>
    </message>
    <message>
        <source>Corrected by hand.</source>
        <translation>직접 고친 프레임.</translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation>%1 · %2프레임</translation>
    </message>
    <message>
        <source>%1 pins stand: fewer are a digit, all of them /</source>
        <translation>서 있는 핀은 %1개입니다. 그보다 적으면 숫자로, 모두 쓰러지면 /로 적습니다</translation>
    </message>
    <message>
        <source>X is all ten at the first ball; a spare is written /</source>
        <translation>X는 첫 투구에 10개를 모두 쓰러뜨린 것이고, 스페어는 /로 적습니다</translation>
    </message>
    <message>
        <source>/ is a spare; all ten at the first ball are written X</source>
        <translation>/는 스페어이고, 첫 투구에 10개가 모두 쓰러지면 X로 적습니다</translation>
    </message>
    <message>
        <source>the second ball is missing</source>
        <translation>두 번째 투구가 빠졌습니다</translation>
    </message>
    <message>
        <source>this is more than one frame</source>
        <translation>한 프레임을 넘습니다</translation>
    </message>
    <message>
        <source>rolls are X, /, -, F and the digits 1 to 9</source>
        <translation>투구는 X, /, -, F와 숫자 1~9로 적습니다</translation>
    </message>
</context>
<context>
    <name>Instant</name>
    <message>
        <source>Contact %1 of %2 at this instant</source>
        <translation>이 순간의 접촉 %2개 중 %1번째</translation>
    </message>
    <message numerus="yes">
        <source>pass %1 of %2: %n contacts resolved together</source>
        <translation>
            <numerusform>%2회차 중 %1회차: 접촉 %n개를 함께 계산</numerusform>
        </translation>
    </message>
    <message>
        <source>pass %1 of %2, one pass after another</source>
        <translation>%2회차 중 %1회차: 한 번에 하나씩 차례로 계산</translation>
    </message>
    <message>
        <source>Why together?</source>
        <translation>왜 함께 계산하나요?</translation>
    </message>
    <message>
        <source>Why one after another?</source>
        <translation>왜 차례로 계산하나요?</translation>
    </message>
    <message>
        <source>All contacts at one instant whose bodies approach are resolved together, in one pass: each gets an impulse that can only push, and parts its two bodies with e times the speed at which they met, unless the other impulses part them faster still. Taken one by one, the outcome would depend on the order, and what is symmetric would not stay so. Passes repeat until no two bodies approach; the energy never rises.</source>
        <translation>같은 순간의 접촉 가운데 두 물체가 서로 다가가는 접촉은 모두 한 회차에 함께 계산합니다. 각 접촉의 충격량은 밀기만 하며, 두 물체는 다가가던 속력의 e배로 멀어집니다. 다만 다른 충격량이 이미 더 빠르게 떼어 놓으면 그대로 둡니다. 하나씩 계산하면 결과가 순서에 따라 달라지고 대칭이 깨집니다. 다가가는 두 물체가 없을 때까지 회차를 되풀이하며, 운동 에너지는 결코 늘어나지 않습니다.</translation>
    </message>
    <message>
        <source>Only contacts whose bodies approach are resolved, and here that was one at a time: it set the next two bodies approaching, and so the impulse is passed on along the chain. Passes repeat until no two bodies approach; the energy never rises.</source>
        <translation>두 물체가 서로 다가가는 접촉만 계산합니다. 여기서는 그런 접촉이 한 번에 하나씩이었고, 그 결과 다음 두 물체가 다가가게 되어 충격량이 사슬을 따라 차례로 전달됩니다. 다가가는 두 물체가 없을 때까지 회차를 되풀이하며, 운동 에너지는 결코 늘어나지 않습니다.</translation>
    </message>
    <message>
        <source>The paper&apos;s loop goes through the pairs at every step and exchanges each that overlaps by itself, in the order of the list. The outcome depends on that order, and what is symmetric does not stay so; the exact way resolves such contacts together.</source>
        <translation>논문의 반복 계산은 매 시간 간격마다 쌍을 차례로 살펴, 겹친 쌍을 목록의 순서대로 하나씩 따로 계산합니다. 그래서 결과가 순서에 따라 달라지고 대칭이 유지되지 않습니다. 정확한 계산에서는 이런 접촉을 함께 계산합니다.</translation>
    </message>
    <message>
        <source>Here contacts of one instant are exchanged one at a time, in the order of the list. The outcome depends on that order, and what is symmetric does not stay so; the exact way resolves such contacts together.</source>
        <translation>여기서는 같은 순간의 접촉을 목록의 순서대로 하나씩 계산합니다. 그래서 결과가 순서에 따라 달라지고 대칭이 유지되지 않습니다. 정확한 계산에서는 이런 접촉을 함께 계산합니다.</translation>
    </message>
</context>
<context>
    <name>LabPlotText</name>
    <message>
        <source>way of a step v·h [m]</source>
        <translation>한 간격에 가는 거리 v·h [m]</translation>
    </message>
    <message>
        <source>went through [%]</source>
        <translation>통과한 비율 [%]</translation>
    </message>
    <message>
        <source>1 − 2(r₁ + r₂)/(v·h)</source>
        <translation>1 − 2(r₁ + r₂)/(v·h)</translation>
    </message>
    <message>
        <source>step [s]</source>
        <translation>시간 간격 [s]</translation>
    </message>
    <message>
        <source>hit more than once [%]</source>
        <translation>두 번 이상 부딪친 비율 [%]</translation>
    </message>
    <message>
        <source>cost of a throw [µs]</source>
        <translation>투구 한 번의 계산 시간 [µs]</translation>
    </message>
    <message>
        <source>other pins down [%]</source>
        <translation>쓰러진 핀이 달라진 비율 [%]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>시간 [s]</translation>
    </message>
    <message>
        <source>position error, median [m]</source>
        <translation>위치 오차, 중앙값 [m]</translation>
    </message>
    <message>
        <source>%1
after %2 s: off by %3 m</source>
        <translation>%1
%2 s 뒤: %3 m 벗어남</translation>
    </message>
    <message>
        <source>same pins touched %1 · same contacts %2</source>
        <translation>같은 핀에 닿음 %1 · 접촉이 모두 같음 %2</translation>
    </message>
    <message>
        <source>Error against cost</source>
        <translation>계산 시간과 오차</translation>
    </message>
    <message>
        <source>Error over time</source>
        <translation>시간에 따른 오차</translation>
    </message>
    <message>
        <source>Went through, by the way of a step</source>
        <translation>한 간격에 가는 거리와 통과한 비율</translation>
    </message>
    <message>
        <source>Hit more than once, by step</source>
        <translation>시간 간격과 두 번 이상 부딪친 비율</translation>
    </message>
    <message>
        <source>Pins changed against cost</source>
        <translation>계산 시간과 달라진 핀</translation>
    </message>
</context>
<context>
    <name>LabSentence</name>
    <message>
        <source>At %1 m/s and %2 the ball moves %3 in a step: less than 2(r₁ + r₂) = %4, so it cannot skip the pin. It went through in 0 of %5 throws.</source>
        <translation>속력 %1 m/s, 시간 간격 %2일 때 공은 한 간격에 %3를 갑니다. 2(r₁ + r₂) = %4보다 짧으므로 핀을 건너뛸 수 없습니다. 투구 %5번 가운데 0번 통과했습니다.</translation>
    </message>
    <message>
        <source>At %1 m/s and %2 the ball moves %3 in a step: more than 2(r₁ + r₂) = %4. It went through the pin in %5 of %6 throws; swept steps of the same length: in %7.</source>
        <translation>속력 %1 m/s, 시간 간격 %2일 때 공은 한 간격에 %3를 갑니다. 2(r₁ + r₂) = %4보다 깁니다. 투구 %6번 가운데 %5에서 공이 핀을 통과했습니다. 같은 시간 간격으로 연속 충돌 검사를 하면 %7입니다.</translation>
    </message>
    <message>
        <source>With a step of 1/60 s the loop hits the pin more than once in %1 of %2 throws; with 1/100000 s still in %3. The overlap shrinks with the step, and so does the way out of it. Exchanging only when they approach: %4.</source>
        <translation>시간 간격이 1/60 s이면 투구 %2번 가운데 %1에서 핀을 두 번 이상 칩니다. 1/100000 s로 줄여도 %3입니다. 간격을 줄이면 겹친 깊이가 줄지만, 한 간격에 빠져나오는 거리도 똑같이 줄기 때문입니다. 다가갈 때만 속도를 교환하면 %4입니다.</translation>
    </message>
    <message>
        <source>From 1/60 s to 1/10000 s the paper&apos;s loop goes from %1 to %2 of the throws with the right pins touched.</source>
        <translation>시간 간격을 1/60 s에서 1/10000 s로 줄이면, 논문의 반복 계산에서 닿은 핀이 모두 맞는 투구는 %1에서 %2로 바뀝니다.</translation>
    </message>
    <message>
        <source>It costs %1 times as much.</source>
        <translation>계산 시간은 %1배가 됩니다.</translation>
    </message>
    <message>
        <source>Exchanging only when they approach: %1. From contact to contact: %2</source>
        <translation>다가갈 때만 속도를 교환하면 %1, 접촉에서 다음 접촉으로 바로 가면 %2</translation>
    </message>
    <message>
        <source>, in %1 a throw</source>
        <translation>(투구 한 번에 %1)</translation>
    </message>
    <message>
        <source>For the question which pins are touched, yes: the same in all of %1 throws.</source>
        <translation>어느 핀에 닿는지만 알려면 충분합니다. 투구 %1번 모두에서 같은 핀에 닿았습니다.</translation>
    </message>
    <message>
        <source>Not always: the same pins are touched in %2 of %1 throws.</source>
        <translation>늘 충분하지는 않습니다. 같은 핀에 닿은 것은 투구 %1번 가운데 %2입니다.</translation>
    </message>
    <message>
        <source>At the end float is off by %1 in half of them and by up to %3; double by %2.</source>
        <translation>끝난 때의 위치 오차는 단정밀도에서 중앙값 %1, 최댓값 %3이고 배정밀도에서 중앙값 %2입니다.</translation>
    </message>
    <message>
        <source>Float takes %1 times the time of double.</source>
        <translation>단정밀도의 계산 시간은 배정밀도의 %1배입니다.</translation>
    </message>
    <message>
        <source>Digits left after the last contact of the throw below: %1 and %2.</source>
        <translation>아래 투구에서 마지막 접촉 뒤에 남은 자릿수는 각각 %1자리와 %2자리입니다.</translation>
    </message>
    <message>
        <source>Leaving out friction changes which pins fall in %1 of %2 throws.</source>
        <translation>마찰을 빼면 투구 %2번 가운데 %1에서 쓰러지는 핀이 달라집니다.</translation>
    </message>
    <message>
        <source>Friction takes %1 of the time: %2 a throw with it, %3 without.</source>
        <translation>마찰을 계산하는 데 전체 시간의 %1가 듭니다. 투구 한 번에 마찰이 있으면 %2, 없으면 %3입니다.</translation>
    </message>
    <message>
        <source>What matters least is %1: %2.</source>
        <translation>빼도 가장 덜 달라지는 것은 ‘%1’입니다(%2).</translation>
    </message>
    <message>
        <source>%1 to the left becomes %2 in half of the throws after %3 s, and %4 in the worst: %5 times as much. Other pins fall in %6 of %7 throws; with %8 to the left, in %9.</source>
        <translation>왼쪽으로 %1 옮긴 차이가 %3 s 뒤에는 중앙값 %2, 최댓값 %4로 커집니다. 최대 %5배입니다. 쓰러지는 핀이 달라진 것은 투구 %7번 가운데 %6이고, %8 옮기면 %9입니다.</translation>
    </message>
    <message>
        <source>After %1 s the nearest to the truth is %2 (off by %3), the furthest %4 (off by %5).</source>
        <translation>%1 s 뒤에 참값에 가장 가까운 것은 ‘%2’(오차 %3)이고, 가장 먼 것은 ‘%4’(오차 %5)입니다.</translation>
    </message>
</context>
<context>
    <name>LabWords</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>contact %1, %2 at %3 s</source>
        <translation>%1번째 접촉 %2, %3 s</translation>
    </message>
    <message>
        <source>It went through</source>
        <translation>뚫고 지나갔다</translation>
    </message>
    <message>
        <source>It hit twice</source>
        <translation>두 번 쳤다</translation>
    </message>
    <message>
        <source>Smaller step, no better</source>
        <translation>간격을 줄여도 그대로</translation>
    </message>
    <message>
        <source>Is float enough?</source>
        <translation>단정밀도로 충분할까?</translation>
    </message>
    <message>
        <source>What friction costs</source>
        <translation>마찰 계산의 비용</translation>
    </message>
    <message>
        <source>Butterfly: 1 µm to the left</source>
        <translation>나비 효과: 왼쪽으로 1 µm</translation>
    </message>
    <message>
        <source>A fast ball, a pin, and steps so long that the ball can skip through it</source>
        <translation>빠른 공과 핀 하나, 그리고 공이 핀을 건너뛸 만큼 긴 시간 간격</translation>
    </message>
    <message>
        <source>One ball, one pin, e = 0.75: how often the paper&apos;s loop exchanges one contact</source>
        <translation>공 하나와 핀 하나, e = 0.75: 논문의 반복 계산은 한 접촉을 몇 번이나 처리하는가</translation>
    </message>
    <message>
        <source>Throws at the rack with ever smaller steps, against the exact method</source>
        <translation>시간 간격을 줄여 가며 핀 열 개에 던지고 정확한 계산과 비교합니다</translation>
    </message>
    <message>
        <source>Throws at the rack with 24, 53 and 113 bits</source>
        <translation>24, 53, 113비트로 핀 열 개에 던집니다</translation>
    </message>
    <message>
        <source>Throws down the whole lane with all models, then with one left out each</source>
        <translation>레인 전체에서 모든 모형을 넣고 던진 뒤, 하나씩 빼고 다시 던집니다</translation>
    </message>
    <message>
        <source>The same throws at the rack with the ball a little to the left; no method errs here</source>
        <translation>공을 왼쪽으로 조금 옮겨 같은 투구를 합니다. 여기서는 계산 방법의 오차가 없습니다</translation>
    </message>
    <message>
        <source>ball %1 to the left</source>
        <translation>공을 왼쪽으로 %1</translation>
    </message>
    <message>
        <source>with all models</source>
        <translation>모든 모형 포함</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>%1 없이</translation>
    </message>
    <message>
        <source>%1 of %2 throws</source>
        <translation>투구 %2번 중 %1번</translation>
    </message>
    <message>
        <source>one scene, %1 s</source>
        <translation>장면 하나, %1 s</translation>
    </message>
    <message>
        <source>%1 s of %2 s: further the truth would take too long</source>
        <translation>%2 s 가운데 %1 s까지: 그 뒤의 참값은 계산이 너무 오래 걸립니다</translation>
    </message>
    <message>
        <source>%1 · about %2 s left</source>
        <translation>%1 · 약 %2 s 남음</translation>
    </message>
    <message>
        <source>Cancelled after %1 s; shown is what there is: %2</source>
        <translation>%1 s 만에 취소했습니다. 그때까지의 결과입니다: %2</translation>
    </message>
    <message>
        <source>%1 · measured in %2 s</source>
        <translation>%1 · 측정 시간 %2 s</translation>
    </message>
    <message>
        <source>%1: leaves at %2 s</source>
        <translation>%1: %2 s에 벗어남</translation>
    </message>
    <message>
        <source>%1: stays to the end</source>
        <translation>%1: 끝까지 같음</translation>
    </message>
    <message>
        <source>At %1 s, at %2, the body “%3” is more than %4 mm from where it should be.</source>
        <translation>%1 s에 %2에서 물체 ‘%3’의 위치가 참값에서 %4 mm 넘게 벗어납니다.</translation>
    </message>
    <message>
        <source>No body is ever more than %1 mm from where it should be.</source>
        <translation>어느 물체도 참값에서 %1 mm 넘게 벗어나지 않습니다.</translation>
    </message>
    <message>
        <source>The first contact that differs: should be %1; here: %2.</source>
        <translation>처음으로 다른 접촉: 참값은 %1, 여기서는 %2.</translation>
    </message>
    <message>
        <source>All contacts are the same.</source>
        <translation>접촉은 모두 같습니다.</translation>
    </message>
    <message>
        <source>Digits left after the last contact: %1.</source>
        <translation>마지막 접촉 뒤에 남은 자릿수: %1.</translation>
    </message>
</context>
<context>
    <name>Leaves</name>
    <message>
        <source>10 pin</source>
        <translation>10번 핀</translation>
    </message>
    <message>
        <source>7 pin</source>
        <translation>7번 핀</translation>
    </message>
    <message>
        <source>Baby split 3-10</source>
        <translation>베이비 스플릿 3-10</translation>
    </message>
    <message>
        <source>Baby split 2-7</source>
        <translation>베이비 스플릿 2-7</translation>
    </message>
    <message>
        <source>Split 5-7</source>
        <translation>스플릿 5-7</translation>
    </message>
    <message>
        <source>Split 7-10</source>
        <translation>스플릿 7-10</translation>
    </message>
    <message>
        <source>Split 6-7-10</source>
        <translation>스플릿 6-7-10</translation>
    </message>
    <message>
        <source>Big four 4-6-7-10</source>
        <translation>빅 포 4-6-7-10</translation>
    </message>
    <message>
        <source>Bucket 2-4-5-8</source>
        <translation>버킷 2-4-5-8</translation>
    </message>
    <message>
        <source>Bucket 3-5-6-9</source>
        <translation>버킷 3-5-6-9</translation>
    </message>
    <message>
        <source>Washout 1-2-4-10</source>
        <translation>워시아웃 1-2-4-10</translation>
    </message>
    <message>
        <source>Washout 1-3-6-7</source>
        <translation>워시아웃 1-3-6-7</translation>
    </message>
    <message>
        <source>All ten pins</source>
        <translation>핀 열 개 모두</translation>
    </message>
    <message>
        <source>No pins</source>
        <translation>핀 없음</translation>
    </message>
    <message>
        <source>Pins %1</source>
        <translation>핀 %1</translation>
    </message>
</context>
<context>
    <name>LessonText</name>
    <message>
        <source>&quot;%1&quot; is not known; did you mean &quot;%2&quot;?</source>
        <translation>알 수 없는 값 &quot;%1&quot;입니다. &quot;%2&quot;인지 확인하십시오.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not fit here; must be one of %2</source>
        <translation>여기에 쓸 수 없는 값 &quot;%1&quot;입니다. 다음 가운데 하나여야 합니다: %2</translation>
    </message>
    <message>
        <source>needs either &quot;at&quot; (&quot;start&quot;, or seconds) or &quot;collision&quot; (a number from 1)</source>
        <translation>&quot;at&quot;(&quot;start&quot; 또는 초)이나 &quot;collision&quot;(1부터 세는 번호) 가운데 하나만 있어야 합니다</translation>
    </message>
    <message>
        <source>there is no collision %1; the last one is %2</source>
        <translation>%1번 충돌이 없습니다. 마지막 충돌은 %2번입니다</translation>
    </message>
    <message>
        <source>there is no collision %1; nothing collides in this scene</source>
        <translation>%1번 충돌이 없습니다. 이 장면에서는 충돌이 일어나지 않습니다</translation>
    </message>
    <message>
        <source>must be at most %1 s, where the run ends, is %2</source>
        <translation>계산이 끝나는 %1 s 이하여야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>has no answer here; add &quot;after&quot;: the number of a collision after which the body moves</source>
        <translation>여기서는 답이 정해지지 않습니다. 물체가 움직이고 있는 충돌의 번호를 &quot;after&quot;에 적으십시오</translation>
    </message>
    <message>
        <source>must be &quot;%1&quot;, is &quot;%2&quot;</source>
        <translation>&quot;%1&quot;이어야 하는데 &quot;%2&quot;입니다</translation>
    </message>
    <message>
        <source>must be 1, is %1</source>
        <translation>1이어야 하는데 %1입니다</translation>
    </message>
    <message>
        <source>there is no body &quot;%1&quot;; there are %2</source>
        <translation>&quot;%1&quot;이라는 물체가 없습니다. 있는 물체는 %2입니다</translation>
    </message>
    <message>
        <source>must be a whole number, is %1</source>
        <translation>정수여야 하는데 %1입니다</translation>
    </message>
    <message>
        <source>must be from %1 to %2, is %3</source>
        <translation>%1 이상 %2 이하여야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>must have a text in &quot;en&quot; or &quot;ko&quot;</source>
        <translation>&quot;en&quot;이나 &quot;ko&quot;에 글이 있어야 합니다</translation>
    </message>
    <message>
        <source>must hold at least one stop</source>
        <translation>멈출 곳이 적어도 하나 있어야 합니다</translation>
    </message>
    <message>
        <source>must hold at least two options, holds %1</source>
        <translation>보기가 적어도 두 개 있어야 하는데 %1개입니다</translation>
    </message>
    <message>
        <source>Speed of %1</source>
        <translation>%1의 속력</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>%1의 방향</translation>
    </message>
    <message>
        <source>Angle between %1 and %2</source>
        <translation>%1, %2 사이의 각</translation>
    </message>
    <message>
        <source>Angle θ</source>
        <translation>각 θ</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
    <message>
        <source>Total momentum</source>
        <translation>운동량의 합</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>충돌 횟수</translation>
    </message>
    <message>
        <source>Pins down</source>
        <translation>쓰러진 핀의 수</translation>
    </message>
    <message>
        <source>Velocity of %1</source>
        <translation>%1의 속도</translation>
    </message>
</context>
<context>
    <name>MainText</name>
    <message>
        <source>%1: there is no such command;</source>
        <translation>%1: 그런 명령은 없습니다.</translation>
    </message>
    <message>
        <source>thetalane --help lists them</source>
        <translation>thetalane --help로 명령 목록을 볼 수 있습니다</translation>
    </message>
    <message>
        <source>Commands, each with a --help of its own:</source>
        <translation>명령 (명령마다 --help가 있습니다):</translation>
    </message>
    <message>
        <source>Opens the window, or does what the command says without one.</source>
        <translation>창을 엽니다. 명령을 주면 창 없이 그 명령을 수행합니다.</translation>
    </message>
    <message>
        <source>what to open: a built-in name or a scene file</source>
        <translation>열 장면: 내장 장면의 이름 또는 장면 파일</translation>
    </message>
    <message>
        <source>larger, for the back row of a class</source>
        <translation>교실 뒷자리에서도 보이도록 크게 표시합니다</translation>
    </message>
    <message>
        <source>prints the version</source>
        <translation>버전을 출력합니다</translation>
    </message>
    <message>
        <source>must be ko or en, is &quot;%1&quot;</source>
        <translation>ko 또는 en이어야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>light on dark</source>
        <translation>어두운 바탕에 밝은 글자</translation>
    </message>
</context>
<context>
    <name>MapCommandText</name>
    <message>
        <source>rack: ten pins without friction; bowling: the whole lane; rack unless said</source>
        <translation>rack: 마찰이 없는 핀 열 개, bowling: 레인 전체. 지정하지 않으면 rack</translation>
    </message>
    <message>
        <source>how many offsets, the columns; 256 unless said</source>
        <translation>위치의 개수(열). 지정하지 않으면 256</translation>
    </message>
    <message>
        <source>how many entry angles, the rows; 256 unless said</source>
        <translation>입사각의 개수(행). 지정하지 않으면 256</translation>
    </message>
    <message>
        <source>from the head pin, positive to the right; -0.16 unless said</source>
        <translation>헤드핀에서 잰 위치, 오른쪽이 양수. 지정하지 않으면 -0.16</translation>
    </message>
    <message>
        <source>0.16 unless said</source>
        <translation>지정하지 않으면 0.16</translation>
    </message>
    <message>
        <source>of the path at the pins, positive to the left, as a right-hander&apos;s hook comes in; 0 unless said</source>
        <translation>핀에 다다를 때 경로의 각도, 오른손잡이의 훅처럼 왼쪽으로 들어가는 방향이 양수. 지정하지 않으면 0</translation>
    </message>
    <message>
        <source>8 unless said</source>
        <translation>지정하지 않으면 8</translation>
    </message>
    <message>
        <source>rack: at the pins, 6.8 unless said; bowling: at the foul line, 8 unless said</source>
        <translation>rack: 핀 앞에서의 속력, 지정하지 않으면 6.8. bowling: 파울 라인에서의 속력, 지정하지 않으면 8</translation>
    </message>
    <message>
        <source>of the ball, at most 7.26 kg; 6.8 unless said</source>
        <translation>볼 무게, 최대 7.26 kg. 지정하지 않으면 6.8</translation>
    </message>
    <message>
        <source>bowling: direction and axis are found for each cell; 400 unless said</source>
        <translation>bowling: 방향과 회전축은 칸마다 계산해서 정합니다. 지정하지 않으면 400</translation>
    </message>
    <message>
        <source>bowling: at the foul line; 0, the middle, unless said</source>
        <translation>bowling: 파울 라인에서의 위치. 지정하지 않으면 가운데인 0</translation>
    </message>
    <message>
        <source>between bodies; 0.75 unless said</source>
        <translation>물체 사이의 반발 계수. 지정하지 않으면 0.75</translation>
    </message>
    <message>
        <source>only these rows, from 1; a part to be merged later</source>
        <translation>이 행들만 계산합니다(1부터 셉니다). 나중에 합칠 부분입니다</translation>
    </message>
    <message>
        <source>as many as the machine has unless said</source>
        <translation>지정하지 않으면 컴퓨터의 코어 수만큼</translation>
    </message>
    <message>
        <source>writes a line for each cell</source>
        <translation>칸마다 한 줄씩 파일에 씁니다</translation>
    </message>
    <message>
        <source>draws the map</source>
        <translation>지도를 그림으로 그립니다</translation>
    </message>
    <message>
        <source>puts the parts in these CSV files together instead of throwing</source>
        <translation>새로 계산하지 않고 이 CSV 파일들에 든 부분을 하나로 합칩니다</translation>
    </message>
    <message>
        <source>must be A-B with 1 &lt;= A &lt;= B &lt;= %1, is &quot;%2&quot;</source>
        <translation>1 &lt;= A &lt;= B &lt;= %1인 A-B 꼴이어야 합니다. 입력한 값: &quot;%2&quot;</translation>
    </message>
    <message>
        <source>has no meaning on the rack; add --scene bowling</source>
        <translation>rack에서는 뜻이 없습니다. --scene bowling을 함께 쓰십시오</translation>
    </message>
    <message>
        <source>must be at most %1</source>
        <translation>%1 이하여야 합니다</translation>
    </message>
    <message>
        <source>must not be less than --offset-from</source>
        <translation>--offset-from보다 작을 수 없습니다</translation>
    </message>
    <message>
        <source>must not be less than --angle-from</source>
        <translation>--angle-from보다 작을 수 없습니다</translation>
    </message>
    <message>
        <source>%1 % of %2 throws</source>
        <translation>투구 %2번 가운데 %1 %</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: 읽을 수 없습니다: %2</translation>
    </message>
    <message>
        <source>has no meaning with --merge; leave one of the two out</source>
        <translation>--merge와 함께 쓸 수 없습니다. 둘 가운데 하나를 빼십시오</translation>
    </message>
    <message>
        <source>Entry angle [°]</source>
        <translation>입사각 [°]</translation>
    </message>
    <message>
        <source>Pins down, mean</source>
        <translation>쓰러진 핀 평균</translation>
    </message>
    <message>
        <source>Strikes</source>
        <translation>스트라이크</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Strike map of the rack without friction</source>
        <translation>마찰이 없는 핀 배열의 스트라이크 지도</translation>
    </message>
    <message>
        <source>Strike map of the whole lane</source>
        <translation>레인 전체의 스트라이크 지도</translation>
    </message>
    <message>
        <source>Throws: %1, strikes: %2</source>
        <translation>투구 %1번, 스트라이크 %2번</translation>
    </message>
    <message>
        <source>Cells that no throw arrives in: %1</source>
        <translation>맞는 투구가 없는 칸: %1</translation>
    </message>
    <message>
        <source>Pins here are discs that slide; real pins fall over and sweep others down. The map shows where the pocket lies and how it widens, not how often a real bowler strikes.</source>
        <translation>여기서 핀은 미끄러지는 원판입니다. 실제 핀은 넘어지면서 다른 핀을 쓸어 넘깁니다. 이 지도는 포켓이 어디에 있고 어떻게 넓어지는지를 보여 줄 뿐, 실제 선수가 스트라이크를 얼마나 자주 치는지를 보여 주지는 않습니다.</translation>
    </message>
    <message>
        <source>needs the name of a file</source>
        <translation>파일 이름이 필요합니다</translation>
    </message>
    <message>
        <source>must end in .png, is &quot;%1&quot;</source>
        <translation>.png로 끝나야 합니다. 입력한 값: &quot;%1&quot;</translation>
    </message>
</context>
<context>
    <name>MapText</name>
    <message>
        <source>less than 1 s left</source>
        <translation>1 s 안에 끝남</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>약 %1 s 남음</translation>
    </message>
    <message>
        <source>In %1 % of the places no throw arrives: too little spin for the angle, or the lane too narrow.</source>
        <translation>전체 칸의 %1 %에는 닿는 투구가 없습니다. 입사각을 만들기에 회전이 모자라거나 레인이 좁기 때문입니다.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>벗어난 거리</translation>
    </message>
    <message>
        <source>Entry angle</source>
        <translation>입사각</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Ball weight</source>
        <translation>볼 무게</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation>분당 %1회전</translation>
    </message>
    <message>
        <source>No throw arrives so.</source>
        <translation>이렇게 들어오는 투구가 없습니다.</translation>
    </message>
    <message>
        <source>10 pins down: a strike</source>
        <translation>핀 10개 쓰러짐: 스트라이크</translation>
    </message>
    <message>
        <source>No pin down</source>
        <translation>쓰러진 핀 없음</translation>
    </message>
    <message>
        <source>Pins down: %1; left standing: %2</source>
        <translation>쓰러진 핀 %1개, 남은 핀 %2</translation>
    </message>
    <message>
        <source>%1 of %2 throws</source>
        <translation>투구 %2번 가운데 %1번</translation>
    </message>
    <message>
        <source>Cancelled before there was a picture.</source>
        <translation>그림이 나오기 전에 취소했습니다.</translation>
    </message>
    <message>
        <source>%1 throws in %2 s, %3 strikes</source>
        <translation>투구 %1번을 %2 s에 계산, 스트라이크 %3번</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, is %4</source>
        <translation>%1: %2에서 %3까지여야 하는데 %4입니다</translation>
    </message>
    <message>
        <source>Without friction spin does nothing; choose another quantity.</source>
        <translation>마찰이 없으면 회전은 아무 영향이 없습니다. 다른 양을 고르십시오.</translation>
    </message>
    <message>
        <source>Such a map cannot be made.</source>
        <translation>이런 지도는 만들 수 없습니다.</translation>
    </message>
    <message>
        <source>Each place is a throw of its own. Pins here are discs that slide, and count as down when struck hard enough to tip; real pins fall over and sweep others down. Read where the pocket lies and how it widens with the angle, not how often a real bowler strikes.</source>
        <translation>칸 하나가 투구 한 번입니다. 여기서 핀은 미끄러지는 원판이고, 넘어질 만큼 세게 맞으면 쓰러진 것으로 셉니다. 실제 핀은 넘어지면서 다른 핀을 쓸어 넘깁니다. 포켓이 어디에 있고 입사각에 따라 어떻게 넓어지는지를 읽으십시오. 실제 선수가 스트라이크를 얼마나 자주 치는지를 뜻하지는 않습니다.</translation>
    </message>
    <message>
        <source>Cancelled after %1 of %2 throws: one column and row in %3 is shown.</source>
        <translation>투구 %2번 가운데 %1번에서 취소했습니다. 행과 열을 %3개마다 하나씩 계산한 그림입니다.</translation>
    </message>
</context>
<context>
    <name>MapWords</name>
    <message>
        <source>must be a number, is &quot;%1&quot;</source>
        <translation>숫자여야 합니다. 적힌 값: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>must be %1, is &quot;%2&quot;</source>
        <translation>%1이어야 합니다. 적힌 값: &quot;%2&quot;</translation>
    </message>
    <message>
        <source>is %1, but %2 in %3; the parts of one map are made with the same settings</source>
        <translation>값이 %1인데 %3에서는 %2입니다. 한 지도의 부분들은 같은 설정으로 만들어야 합니다</translation>
    </message>
    <message>
        <source>is no part of a strike map; line 1 must be &quot;%1&quot;, is &quot;%2&quot;</source>
        <translation>스트라이크 지도의 부분이 아닙니다. 1행은 &quot;%1&quot;이어야 하는데 &quot;%2&quot;입니다</translation>
    </message>
    <message>
        <source>must have %1 fields, has %2</source>
        <translation>필드가 %1개여야 하는데 %2개입니다</translation>
    </message>
    <message>
        <source>row %1 is in %2, too; parts must not overlap</source>
        <translation>지도의 %1행이 %2에도 있습니다. 부분들은 겹치지 않아야 합니다</translation>
    </message>
    <message>
        <source>row %1 has %2 cells, the rows of %4 have %3; make this part again</source>
        <translation>지도의 %1행에 칸이 %2개인데 %4의 행에는 %3개 있습니다. 이 부분을 다시 만드십시오</translation>
    </message>
    <message>
        <source>row %1 is in none of the files; make it with --rows %1-%1</source>
        <translation>지도의 %1행이 어느 파일에도 없습니다. --rows %1-%1로 만드십시오</translation>
    </message>
    <message>
        <source>rows %1 to %2 are in none of the files; make them with --rows %1-%2</source>
        <translation>지도의 %1행부터 %2행까지가 어느 파일에도 없습니다. --rows %1-%2로 만드십시오</translation>
    </message>
    <message>
        <source>has no rows; a part is made with --csv</source>
        <translation>행이 하나도 없습니다. 부분은 --csv로 만듭니다</translation>
    </message>
    <message>
        <source>%1 cells are too many; at most %2 fit</source>
        <translation>칸 %1개는 너무 많습니다. 최대 %2개까지 됩니다</translation>
    </message>
    <message>
        <source>must be within 1 to %1</source>
        <translation>1부터 %1까지의 범위 안이어야 합니다</translation>
    </message>
    <message>
        <source>must be from %1 to %2, is %3</source>
        <translation>%1 이상 %2 이하여야 합니다. 입력한 값: %3</translation>
    </message>
    <message>
        <source>must be at least 1</source>
        <translation>1 이상이어야 합니다</translation>
    </message>
    <message>
        <source>has no meaning on the rack, which has no friction</source>
        <translation>마찰이 없는 rack에서는 뜻이 없습니다</translation>
    </message>
    <message>
        <source>both axes ask for the same</source>
        <translation>두 축이 같은 양을 가리킵니다</translation>
    </message>
    <message>
        <source>line %1: </source>
        <translation>%1번째 줄: </translation>
    </message>
    <message>
        <source>row %1: </source>
        <translation>지도의 %1행: </translation>
    </message>
</context>
<context>
    <name>MethodText</name>
    <message>
        <source>without %1</source>
        <translation>%1 없이</translation>
    </message>
    <message>
        <source>float (24 bits)</source>
        <translation>단정밀도 (24비트)</translation>
    </message>
    <message>
        <source>double (53 bits)</source>
        <translation>배정밀도 (53비트)</translation>
    </message>
    <message>
        <source>quad (113 bits)</source>
        <translation>4배 정밀도 (113비트)</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>마찰</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>oil</source>
        <translation>오일</translation>
    </message>
    <message>
        <source>loss between bodies (e = 1)</source>
        <translation>물체 사이의 에너지 손실 (e = 1)</translation>
    </message>
    <message>
        <source>loss at the walls (e = 1)</source>
        <translation>벽의 에너지 손실 (e = 1)</translation>
    </message>
    <message>
        <source>the rule of ties</source>
        <translation>동시 충돌 규칙</translation>
    </message>
    <message>
        <source>next event</source>
        <translation>정확한 계산 (다음 충돌)</translation>
    </message>
    <message>
        <source>swept, one pass</source>
        <translation>연속 충돌 검사, 탐색 1회</translation>
    </message>
    <message>
        <source>swept, %1 passes</source>
        <translation>연속 충돌 검사, 탐색 %1회</translation>
    </message>
    <message>
        <source>paper&apos;s loop, approaching only</source>
        <translation>논문의 반복 계산, 다가갈 때만</translation>
    </message>
    <message>
        <source>paper&apos;s loop</source>
        <translation>논문의 반복 계산</translation>
    </message>
</context>
<context>
    <name>NoWindow</name>
    <message>
        <source>this program was built without the window; thetalane --help lists the commands</source>
        <translation>이 프로그램은 창 없이 빌드되었습니다. thetalane --help로 명령 목록을 볼 수 있습니다</translation>
    </message>
    <message>
        <source>picture: this program was built without the window, and cannot draw it</source>
        <translation>picture: 이 프로그램은 창 없이 빌드되어 창을 그릴 수 없습니다</translation>
    </message>
    <message>
        <source>--picture: this program was built without the window, and cannot draw it</source>
        <translation>--picture: 창 없이 빌드된 프로그램이어서 그림을 그릴 수 없습니다</translation>
    </message>
    <message>
        <source>worksheet: this program was built without the window, and cannot draw it</source>
        <translation>worksheet: 이 프로그램은 창 없이 만들어져 활동지를 그릴 수 없습니다</translation>
    </message>
</context>
<context>
    <name>OptionsText</name>
    <message>
        <source>must be greater than %1, is %2</source>
        <translation>%1보다 커야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>must be at least %1, is %2</source>
        <translation>%1 이상이어야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>must be from %1 to %2, is %3</source>
        <translation>%1부터 %2까지여야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>must be greater than %1 and at most %2, is %3</source>
        <translation>%1보다 크고 %2 이하여야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>must be greater than %1 and less than %2, is %3</source>
        <translation>%1보다 크고 %2보다 작아야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>did you mean &quot;%1&quot;?</source>
        <translation>혹시 &quot;%1&quot;입니까?</translation>
    </message>
    <message>
        <source>%1 is missing; the call is: thetalane %2</source>
        <translation>%1: 빠져 있습니다. 사용법: thetalane %2</translation>
    </message>
    <message>
        <source>%1: one argument too many; the call is: thetalane %2</source>
        <translation>%1: 필요 없는 인수입니다. 사용법: thetalane %2</translation>
    </message>
    <message>
        <source>%1: takes no value</source>
        <translation>%1: 값을 받지 않는 옵션입니다</translation>
    </message>
    <message>
        <source>%1: needs a value</source>
        <translation>%1: 값이 필요합니다</translation>
    </message>
    <message>
        <source>%1: there is no such option; did you mean --%2?</source>
        <translation>%1: 그런 옵션은 없습니다. 혹시 --%2입니까?</translation>
    </message>
    <message>
        <source>%1: there is no such option; thetalane %2--help lists them</source>
        <translation>%1: 그런 옵션은 없습니다. thetalane %2--help로 옵션 목록을 볼 수 있습니다</translation>
    </message>
    <message>
        <source>must be a number, is &quot;%1&quot;</source>
        <translation>수여야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>must be a whole number greater than 0, is &quot;%1&quot;</source>
        <translation>0보다 큰 정수여야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>must be one of %1, is &quot;%2&quot;</source>
        <translation>%1 가운데 하나여야 하는데 &quot;%2&quot;입니다</translation>
    </message>
    <message>
        <source>Usage: thetalane %1</source>
        <translation>사용법: thetalane %1</translation>
    </message>
    <message>
        <source>the language of what is printed; the system&apos;s unless said</source>
        <translation>출력 언어. 기본값은 시스템의 언어</translation>
    </message>
    <message>
        <source>prints this</source>
        <translation>이 도움말을 출력합니다</translation>
    </message>
</context>
<context>
    <name>PictureCommand</name>
    <message>
        <source>must be WIDTHxHEIGHT, each from %1 to %2, is &quot;%3&quot;</source>
        <translation>가로x세로로 쓰고 각각 %1부터 %2까지여야 하는데 &quot;%3&quot;입니다</translation>
    </message>
    <message>
        <source>is the stage of a collision; say which with --collision</source>
        <translation>충돌의 단계입니다. 어느 충돌인지 --collision으로 알려 주십시오</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to %1, is %2</source>
        <translation>0부터 %1까지의 정수여야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>is missing; say where the picture goes, FILE.png</source>
        <translation>빠졌습니다. 그림을 저장할 곳을 FILE.png로 알려 주십시오</translation>
    </message>
    <message>
        <source>must end in .png, is &quot;%1&quot;</source>
        <translation>.png로 끝나야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>nothing collides in this scene</source>
        <translation>이 장면에서는 충돌이 일어나지 않습니다</translation>
    </message>
    <message>
        <source>must be from 1 to %1, the number of collisions, is %2</source>
        <translation>1부터 충돌 횟수 %1까지여야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>where the picture goes</source>
        <translation>그림을 저장할 파일</translation>
    </message>
    <message>
        <source>the moment to show, in seconds; 0 unless said</source>
        <translation>보여 줄 시각(초). 기본값 0</translation>
    </message>
    <message>
        <source>the collision to open, from 1</source>
        <translation>펼쳐 볼 충돌의 번호. 1부터 셉니다</translation>
    </message>
    <message>
        <source>its stage: 0 contact, 1 split, 2 rotation, 3 exchange, 4 back, 5 check</source>
        <translation>충돌의 단계: 0 접촉, 1 속도의 분해, 2 좌표축의 회전, 3 x′축의 1차원 충돌, 4 역회전, 5 확인</translation>
    </message>
    <message>
        <source>of the picture, in pixels; 1280x800 unless said</source>
        <translation>그림의 크기(픽셀). 기본값 1280x800</translation>
    </message>
    <message>
        <source>larger, for the back row of a class</source>
        <translation>교실 뒷자리에서도 보이도록 크게 표시합니다</translation>
    </message>
    <message>
        <source>a collision has its own moment; say --at or --collision, not both</source>
        <translation>충돌의 시각은 이미 정해져 있습니다. --at과 --collision 가운데 하나만 쓰십시오</translation>
    </message>
    <message>
        <source>must be from 1 to %1, is %2</source>
        <translation>1 이상 %1 이하여야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>opens the accuracy lab on its question 1 to 6, measured here and now</source>
        <translation>정확도 실험실을 열어 질문 1–6 가운데 하나를 그 자리에서 측정합니다</translation>
    </message>
    <message>
        <source>the panel to open: %1</source>
        <translation>열어 둘 패널: %1</translation>
    </message>
    <message>
        <source>light on dark</source>
        <translation>어두운 바탕에 밝은 글자</translation>
    </message>
    <message>
        <source>a saved game to go on with</source>
        <translation>이어서 할 저장된 게임</translation>
    </message>
</context>
<context>
    <name>PlayerColours</name>
    <message>
        <source>blue</source>
        <translation>파랑</translation>
    </message>
    <message>
        <source>red</source>
        <translation>빨강</translation>
    </message>
    <message>
        <source>green</source>
        <translation>초록</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>분홍</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>주황</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>하늘색</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>회색</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>노랑</translation>
    </message>
</context>
<context>
    <name>PredictWords</name>
    <message>
        <source>Kinetic energy came from nothing: %1 J before, %2 J in your prediction, as if e were above 1.</source>
        <translation>없던 운동 에너지가 생겼습니다. 충돌 전에는 %1 J인데, 예측에서는 %2 J입니다. e가 1보다 큰 셈입니다.</translation>
    </message>
    <message>
        <source>They part with e = %1; here e = %2.</source>
        <translation>예측대로라면 e = %1인데, 여기서는 e = %2입니다.</translation>
    </message>
    <message>
        <source>The total momentum is what it was before: %1 kg·m/s in all.</source>
        <translation>운동량의 합은 충돌 전과 같으며, 그 크기는 %1 kg·m/s입니다.</translation>
    </message>
    <message>
        <source>The energy lost is %1 J, not %2 J.</source>
        <translation>에너지 손실은 %2 J이 아니라 %1 J입니다.</translation>
    </message>
    <message>
        <source>A collision never gains kinetic energy: what is lost is 0 J or more.</source>
        <translation>충돌로 운동 에너지가 늘어나는 일은 없습니다. 에너지 손실은 0 J 이상입니다.</translation>
    </message>
    <message>
        <source>You let them go on as if they had not met.</source>
        <translation>서로 부딪치지 않은 것처럼 그대로 지나가게 했습니다.</translation>
    </message>
    <message>
        <source>You left %1 as it was; but action and reaction change both.</source>
        <translation>%1의 속도를 그대로 두었습니다. 작용 반작용으로 두 물체의 속도가 모두 변합니다.</translation>
    </message>
    <message>
        <source>They would go through each other: along x′ they still approach.</source>
        <translation>서로 뚫고 지나가게 됩니다. x′축 방향으로 여전히 다가가고 있습니다.</translation>
    </message>
    <message>
        <source>Right arrows, but swapped: each body has the one of the other.</source>
        <translation>화살표는 맞지만 서로 바뀌었습니다. 두 물체의 속도를 맞바꾸어 보십시오.</translation>
    </message>
    <message>
        <source>You exchanged the whole velocities; only their x′ components are exchanged.</source>
        <translation>속도 전체를 맞바꾸었습니다. 맞바뀌는 것은 x′ 성분뿐입니다.</translation>
    </message>
    <message>
        <source>Right for equal masses; but these masses differ.</source>
        <translation>질량이 같을 때의 답입니다. 그러나 두 물체의 질량은 다릅니다.</translation>
    </message>
    <message>
        <source>You changed the y′ component of %1, but no force acts along y′.</source>
        <translation>%1의 y′ 성분을 바꾸었지만, y′축 방향으로는 힘이 작용하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 goes just the other way.</source>
        <translation>%1의 방향이 정반대입니다.</translation>
    </message>
    <message>
        <source>Every arrow and every number counts alike: all of its points within %1 %, none beyond %2 %, evenly in between.</source>
        <translation>화살표와 수의 배점은 모두 같습니다. 오차가 %1 % 이내이면 만점, %2 % 이상이면 0점이고, 그 사이에서는 고르게 줄어듭니다.</translation>
    </message>
    <message>
        <source>All right!</source>
        <translation>모두 맞았습니다!</translation>
    </message>
    <message>
        <source>Nearly right.</source>
        <translation>거의 맞았습니다.</translation>
    </message>
    <message>
        <source>Partly right.</source>
        <translation>일부가 맞았습니다.</translation>
    </message>
    <message>
        <source>It comes out differently.</source>
        <translation>결과가 다릅니다.</translation>
    </message>
    <message>
        <source>Momentum is not kept: yours points in another direction than before.</source>
        <translation>운동량이 보존되지 않습니다. 예측한 운동량의 방향이 충돌 전과 다릅니다.</translation>
    </message>
    <message>
        <source>Momentum is not kept: %1 kg·m/s before, but %2 kg·m/s in your prediction.</source>
        <translation>운동량이 보존되지 않습니다. 충돌 전에는 %1 kg·m/s인데, 예측한 값은 %2 kg·m/s입니다.</translation>
    </message>
</context>
<context>
    <name>RunCommandText</name>
    <message>
        <source>prints JSON for programs</source>
        <translation>프로그램에서 읽을 JSON을 출력합니다</translation>
    </message>
    <message>
        <source>prints a row for each collision</source>
        <translation>충돌마다 한 줄씩 CSV를 출력합니다</translation>
    </message>
    <message>
        <source>leaves the list of collisions out, and out of memory</source>
        <translation>충돌 목록을 출력하지도, 메모리에 두지도 않습니다</translation>
    </message>
    <message>
        <source>--csv: choose either --json or --csv</source>
        <translation>--csv: --json과 --csv 가운데 하나만 고르십시오</translation>
    </message>
    <message>
        <source>--summary: leaves out the collisions that --csv lists; choose one of the two</source>
        <translation>--summary: --csv가 나열하는 충돌 목록을 생략하는 옵션입니다. 둘 중 하나만 고르십시오</translation>
    </message>
</context>
<context>
    <name>RunReportText</name>
    <message>
        <source>event engine</source>
        <translation>event 엔진</translation>
    </message>
    <message>
        <source>stepped engine, step %1 s</source>
        <translation>stepped 엔진, 시간 간격 %1 s</translation>
    </message>
    <message>
        <source>approaching only</source>
        <translation>다가갈 때만 충돌</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>시각 [s]</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Impulse [N·s]</source>
        <translation>충격량 [N·s]</translation>
    </message>
    <message>
        <source>Energy loss [J]</source>
        <translation>에너지 손실 [J]</translation>
    </message>
    <message>
        <source>Momentum, x [kg·m/s]</source>
        <translation>운동량 x 성분 [kg·m/s]</translation>
    </message>
    <message>
        <source>Momentum, y [kg·m/s]</source>
        <translation>운동량 y 성분 [kg·m/s]</translation>
    </message>
    <message>
        <source>Kinetic energy [J]</source>
        <translation>운동 에너지 [J]</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>합계</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>처음</translation>
    </message>
    <message>
        <source>End</source>
        <translation>마지막</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>변화량</translation>
    </message>
    <message>
        <source>Collisions: %1</source>
        <translation>충돌 횟수: %1</translation>
    </message>
    <message>
        <source>Ended at %1 s: %2</source>
        <translation>%1 s에 끝남: %2</translation>
    </message>
    <message>
        <source>Pressed together by friction</source>
        <translation>마찰로 맞눌린 물체</translation>
    </message>
    <message>
        <source>From [s]</source>
        <translation>처음 [s]</translation>
    </message>
    <message>
        <source>To [s]</source>
        <translation>끝 [s]</translation>
    </message>
    <message>
        <source>Tie</source>
        <translation>동시 충돌</translation>
    </message>
    <message>
        <source>Energy of rotation [J]</source>
        <translation>회전 운동 에너지 [J]</translation>
    </message>
    <message>
        <source>1.2 under Tie: the first instant at which several contacts meet, its second pass. Contacts of one pass are resolved together.</source>
        <translation>동시 충돌 1.2는 여러 접촉이 겹친 첫째 순간의 둘째 차례입니다. 같은 차례의 접촉은 한꺼번에 계산합니다.</translation>
    </message>
    <message>
        <source>one contact at a time</source>
        <translation>접촉을 하나씩 계산</translation>
    </message>
    <message>
        <source>swept engine, step %1 s, passes: %2</source>
        <translation>swept 엔진, 시간 간격 %1 s, 탐색 횟수 %2</translation>
    </message>
</context>
<context>
    <name>SaveFile</name>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: 쓸 수 없습니다: %2</translation>
    </message>
</context>
<context>
    <name>SceneCommand</name>
    <message>
        <source>a built-in name; thetalane scenes lists them</source>
        <translation>내장 장면의 이름. thetalane scenes로 목록을 볼 수 있습니다</translation>
    </message>
</context>
<context>
    <name>SceneSourceText</name>
    <message>
        <source>thetalane scenes lists the built-in ones</source>
        <translation>thetalane scenes로 내장 장면의 목록을 볼 수 있습니다</translation>
    </message>
    <message>
        <source>it is larger than %1 MiB</source>
        <translation>파일이 %1 MiB보다 큽니다</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>표준 입력</translation>
    </message>
    <message numerus="yes">
        <source>%1 (and %n more)</source>
        <translation>
            <numerusform>%1 (그 밖에 %n건)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: there is no such built-in scene;</source>
        <translation>%1: 그런 내장 장면은 없습니다.</translation>
    </message>
    <message>
        <source>%1: there is no such scene or file;</source>
        <translation>%1: 그런 장면이나 파일은 없습니다.</translation>
    </message>
    <message>
        <source>a built-in name, a scene file, or - for standard input</source>
        <translation>내장 장면의 이름, 장면 파일, 또는 표준 입력을 뜻하는 -</translation>
    </message>
</context>
<context>
    <name>SceneStore</name>
    <message>
        <source>%1 could not be saved: %2. What was saved before is still there.</source>
        <translation>%1: 저장하지 못했습니다(%2). 이전에 저장한 내용은 그대로 있습니다.</translation>
    </message>
    <message>
        <source>%1: is too large for a scene file</source>
        <translation>%1: 장면 파일로는 너무 큽니다</translation>
    </message>
    <message>
        <source>Unsaved edits cannot be kept safe: %1</source>
        <translation>저장하지 않은 편집 내용을 보관할 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>SceneText</name>
    <message>
        <source>the file is empty</source>
        <translation>파일이 비어 있습니다</translation>
    </message>
    <message>
        <source>unterminated object</source>
        <translation>객체가 닫히지 않았습니다</translation>
    </message>
    <message>
        <source>missing name separator</source>
        <translation>키 뒤에 콜론(:)이 없습니다</translation>
    </message>
    <message>
        <source>unterminated array</source>
        <translation>배열이 닫히지 않았습니다</translation>
    </message>
    <message>
        <source>missing value separator</source>
        <translation>값 사이에 쉼표(,)가 없습니다</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>값으로 쓸 수 없는 내용입니다</translation>
    </message>
    <message>
        <source>invalid termination by number</source>
        <translation>수로 끝날 수 없습니다</translation>
    </message>
    <message>
        <source>illegal number</source>
        <translation>수의 형식이나 범위가 잘못되었습니다</translation>
    </message>
    <message>
        <source>invalid escape sequence</source>
        <translation>이스케이프 표기가 잘못되었습니다</translation>
    </message>
    <message>
        <source>invalid UTF8 string</source>
        <translation>UTF-8 문자열이 아닙니다</translation>
    </message>
    <message>
        <source>unterminated string</source>
        <translation>문자열이 닫히지 않았습니다</translation>
    </message>
    <message>
        <source>object is missing after a comma</source>
        <translation>쉼표 뒤에 내용이 없습니다</translation>
    </message>
    <message>
        <source>too deeply nested document</source>
        <translation>중첩이 너무 깊습니다</translation>
    </message>
    <message>
        <source>too large document</source>
        <translation>문서가 너무 큽니다</translation>
    </message>
    <message>
        <source>garbage at the end of the document</source>
        <translation>문서 끝에 불필요한 내용이 있습니다</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>수여야 합니다</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>따옴표로 묶은 문자열이어야 합니다</translation>
    </message>
    <message>
        <source>must be an object: {…}</source>
        <translation>객체 {…}여야 합니다</translation>
    </message>
    <message>
        <source>must be a list: […]</source>
        <translation>배열 […]이어야 합니다</translation>
    </message>
    <message>
        <source>must be two numbers: [x, y]</source>
        <translation>두 수 [x, y]여야 합니다</translation>
    </message>
    <message>
        <source>must be &quot;ball&quot; or &quot;pin&quot;</source>
        <translation>&quot;ball&quot; 또는 &quot;pin&quot;이어야 합니다</translation>
    </message>
    <message>
        <source>is there twice; an object may have a key only once</source>
        <translation>키가 두 번 나옵니다. 한 객체 안에서 키는 한 번만 쓸 수 있습니다</translation>
    </message>
    <message>
        <source>not valid JSON: %1</source>
        <translation>올바른 JSON이 아닙니다: %1</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>유한한 수여야 합니다</translation>
    </message>
    <message>
        <source>must be greater than 0, is %1</source>
        <translation>0보다 커야 합니다. 지금 값은 %1입니다</translation>
    </message>
    <message>
        <source>must be from %1 to %2, is %3</source>
        <translation>%1부터 %2까지여야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>비워 둘 수 없습니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is taken by an earlier body; every id must be unique</source>
        <translation>&quot;%1&quot; id는 앞의 물체가 이미 쓰고 있습니다. id는 서로 달라야 합니다</translation>
    </message>
    <message>
        <source>must hold at least one body</source>
        <translation>물체가 하나 이상 있어야 합니다</translation>
    </message>
    <message>
        <source>must hold at most %1 bodies, holds %2</source>
        <translation>물체는 %1개까지 둘 수 있는데 %2개가 있습니다</translation>
    </message>
    <message>
        <source>%1 overlaps %2 by %3 m; move them at least that far apart</source>
        <translation>두 물체 %1, %2의 겹친 깊이가 %3 m입니다. 적어도 그만큼 떼어 놓으십시오</translation>
    </message>
    <message>
        <source>%1 is %3 m beyond the %2; move it inside by at least that much</source>
        <translation>물체 %1의 위치가 %2에서 %3 m 벗어났습니다. 적어도 그만큼 안쪽으로 옮기십시오</translation>
    </message>
    <message>
        <source>%1 is not on the lane; its centre must be between the edges of the lane and before its end</source>
        <translation>물체 %1의 중심이 레인 위에 있지 않습니다. 레인의 양쪽 가장자리 사이, 레인 끝보다 앞에 있어야 합니다</translation>
    </message>
    <message>
        <source>must be greater than %1, which is the opposite side, is %2</source>
        <translation>맞은편의 값 %1보다 커야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>빠져 있습니다</translation>
    </message>
    <message>
        <source>is not a known key; remove it</source>
        <translation>알 수 없는 키입니다. 지우십시오</translation>
    </message>
    <message>
        <source>is not a known key; did you mean &quot;%1&quot;?</source>
        <translation>알 수 없는 키입니다. 혹시 &quot;%1&quot;입니까?</translation>
    </message>
    <message>
        <source>must be &quot;thetalane-scene&quot;, is &quot;%1&quot;</source>
        <translation>&quot;thetalane-scene&quot;이어야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>must be 1, is %1</source>
        <translation>1이어야 하는데 %1입니다</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>%1행 %2열</translation>
    </message>
    <message>
        <source>takes %1 steps, more than the %2 allowed; make the step longer or the time shorter</source>
        <translation>허용된 %2단계보다 많은 %1단계가 필요합니다. 시간 간격을 늘리거나 시간을 줄이십시오</translation>
    </message>
    <message>
        <source>the time asked for was reached</source>
        <translation>지정한 시간에 이름</translation>
    </message>
    <message>
        <source>everything is at rest</source>
        <translation>모든 물체가 멈춤</translation>
    </message>
    <message>
        <source>no more collisions can happen</source>
        <translation>더는 충돌이 일어나지 않음</translation>
    </message>
    <message>
        <source>the most collisions allowed were reached</source>
        <translation>최대 충돌 횟수에 이름</translation>
    </message>
    <message>
        <source>left wall</source>
        <translation>왼쪽 벽</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>오른쪽 벽</translation>
    </message>
    <message>
        <source>bottom wall</source>
        <translation>아래쪽 벽</translation>
    </message>
    <message>
        <source>top wall</source>
        <translation>위쪽 벽</translation>
    </message>
    <message>
        <source>a comma or a closing bracket is missing</source>
        <translation>쉼표나 닫는 괄호가 빠졌습니다</translation>
    </message>
    <message>
        <source>a number needs a digit on each side of its point</source>
        <translation>소수점의 앞뒤에 숫자가 있어야 합니다</translation>
    </message>
    <message>
        <source>a control character in a text must be escaped</source>
        <translation>문자열 안의 제어 문자는 이스케이프로 적어야 합니다</translation>
    </message>
    <message>
        <source>must be three numbers: [x, y, z]</source>
        <translation>세 수 [x, y, z]여야 합니다</translation>
    </message>
    <message>
        <source>must be greater than %1 and at most %2, is %3</source>
        <translation>%1보다 크고 %2 이하여야 하는데 %3입니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; begins with &quot;%2&quot;, which names the walls in a run; choose another id</source>
        <translation>&quot;%1&quot; id는 쓸 수 없습니다. &quot;%2&quot;은 실행 결과에서 벽을 가리키는 말입니다. 다른 id를 고르십시오</translation>
    </message>
    <message>
        <source>must be greater than %1, where the oil begins, is %2</source>
        <translation>오일이 시작하는 %1보다 커야 하는데 %2입니다</translation>
    </message>
    <message>
        <source>must be at least %1, where %2 ends, is %3; list the oil zones from low y to high y</source>
        <translation>%2의 끝 %1 이상이어야 하는데 %3입니다. 오일 구간은 y가 작은 것부터 서로 겹치지 않게 적으십시오</translation>
    </message>
    <message>
        <source>must be from %1, the foul line, to %2, the end of the lane, is %3</source>
        <translation>파울 라인 %1부터 레인의 끝 %2까지여야 하는데 %3입니다</translation>
    </message>
</context>
<context>
    <name>ScoreCommandText</name>
    <message>
        <source>Traditional scoring</source>
        <translation>전통 방식 점수 계산</translation>
    </message>
    <message>
        <source>Current-frame scoring (a strike is 30, a spare 10 and its first ball)</source>
        <translation>커런트 프레임 방식 점수 계산 (스트라이크는 30점, 스페어는 10점에 첫 투구의 핀 수를 더합니다)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Rolls</source>
        <translation>투구</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>점수</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>누계</translation>
    </message>
    <message>
        <source>Strikes: %1, spares: %2, open frames: %3</source>
        <translation>스트라이크 %1, 스페어 %2, 오픈 프레임 %3</translation>
    </message>
    <message>
        <source>The game goes on: frame %1, ball %2, %3 pins stand. So far %4 points, at most %5 possible.</source>
        <translation>게임이 끝나지 않았습니다: 다음은 %1프레임 %2번째 투구이고, 서 있는 핀은 %3개입니다. 지금까지 %4점, 가능한 최고 점수는 %5점입니다.</translation>
    </message>
    <message>
        <source>Total: %1, a perfect game</source>
        <translation>총점: %1, 퍼펙트 게임</translation>
    </message>
    <message>
        <source>Total: %1</source>
        <translation>총점: %1</translation>
    </message>
    <message>
        <source>frames separated by spaces: X strike, / spare, 1 to 9, - none, F foul; the tenth with its fill balls, as in XX8</source>
        <translation>빈칸으로 나눈 프레임들: X 스트라이크, / 스페어, 1부터 9까지의 숫자, - 쓰러진 핀 없음, F 파울. 10프레임은 XX8처럼 보너스 투구까지 붙여 씁니다</translation>
    </message>
    <message>
        <source>traditional unless said</source>
        <translation>지정하지 않으면 traditional</translation>
    </message>
    <message>
        <source>prints JSON for programs</source>
        <translation>프로그램에서 읽을 JSON을 출력합니다</translation>
    </message>
</context>
<context>
    <name>ScoreWords</name>
    <message>
        <source>a digit up to %1, - for none, F for a foul or / for a spare</source>
        <translation>%1 이하의 숫자나 -(없음), F(파울), /(스페어)</translation>
    </message>
    <message>
        <source>- for none, F for a foul or / for a spare</source>
        <translation>-(없음)나 F(파울), /(스페어)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no roll; rolls are X, /, -, F and the digits 1 to 9</source>
        <translation>&quot;%1&quot;: 투구 기호가 아닙니다. X, /, -, F와 1부터 9까지의 숫자를 씁니다</translation>
    </message>
    <message>
        <source>0 is no roll; no pins are written -, all ten X</source>
        <translation>0은 투구 기호가 아닙니다. 쓰러진 핀이 없으면 -, 열 개를 모두 쓰러뜨렸으면 X로 씁니다</translation>
    </message>
    <message>
        <source>X stands for all ten at the first ball; here it must be %1</source>
        <translation>X는 첫 투구로 핀 열 개를 모두 쓰러뜨렸을 때 씁니다. 여기에는 %1 중 하나를 써야 합니다</translation>
    </message>
    <message>
        <source>/ needs a ball before it at the same pins; all ten at the first ball are written X</source>
        <translation>/ 앞에는 같은 핀에 던진 투구가 있어야 합니다. 첫 투구로 열 개를 모두 쓰러뜨렸으면 X로 씁니다</translation>
    </message>
    <message>
        <source>%1 is more than the pins that stand, %2; here it must be %3</source>
        <translation>%1: 서 있는 핀의 수 %2보다 많습니다. 여기에는 %3 중 하나를 써야 합니다</translation>
    </message>
    <message>
        <source>%1 takes all pins that stand; a spare is written /</source>
        <translation>%1: 서 있는 핀을 모두 쓰러뜨린 투구입니다. 스페어는 /로 씁니다</translation>
    </message>
    <message>
        <source>the second ball is missing; after %1 there must be %2, without a space</source>
        <translation>두 번째 투구가 없습니다. %1 다음에는 빈칸 없이 %2 중 하나를 써야 합니다</translation>
    </message>
    <message>
        <source>the frame is over before &quot;%1&quot; ends; frames are separated by spaces</source>
        <translation>&quot;%1&quot;에서 프레임이 먼저 끝납니다. 프레임은 빈칸으로 나눕니다</translation>
    </message>
    <message>
        <source>%1 is one roll too many: the game is over; current-frame scoring has no fill balls</source>
        <translation>%1: 게임이 끝난 뒤의 투구입니다. 커런트 프레임 방식에는 보너스 투구가 없습니다</translation>
    </message>
    <message>
        <source>%1 is one roll too many: the game is over; only a strike earns two fill balls, and a spare one</source>
        <translation>%1: 게임이 끝난 뒤의 투구입니다. 10프레임의 보너스 투구는 스트라이크 뒤에 두 번, 스페어 뒤에 한 번뿐입니다</translation>
    </message>
    <message>
        <source>frame %1: %2</source>
        <translation>%1프레임: %2</translation>
    </message>
</context>
<context>
    <name>StrikeMapFigure</name>
    <message>
        <source>pocket</source>
        <translation>포켓</translation>
    </message>
    <message>
        <source>Pins down</source>
        <translation>쓰러진 핀</translation>
    </message>
    <message>
        <source>10, strike</source>
        <translation>10, 스트라이크</translation>
    </message>
    <message>
        <source>no such throw</source>
        <translation>맞는 투구 없음</translation>
    </message>
    <message>
        <source>Strike map: the rack without friction</source>
        <translation>스트라이크 지도: 마찰이 없는 핀 배열</translation>
    </message>
    <message>
        <source>Strike map: the whole lane</source>
        <translation>스트라이크 지도: 레인 전체</translation>
    </message>
    <message>
        <source>Ball %1 kg, %2 m/s</source>
        <translation>볼 %1 kg, %2 m/s</translation>
    </message>
    <message>
        <source>e = %1</source>
        <translation>e = %1</translation>
    </message>
    <message>
        <source>%1 throws, %2 strikes</source>
        <translation>투구 %1번, 스트라이크 %2번</translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation>분당 %1회전</translation>
    </message>
    <message>
        <source>house oil</source>
        <translation>하우스 오일 패턴</translation>
    </message>
    <message>
        <source>Each cell is a throw of its own, counted by pins that were struck hard enough to tip. Pins here are discs that slide; real pins fall over and sweep others down. Read where the pocket lies and how it widens, not how often a real bowler strikes.</source>
        <translation>칸 하나가 투구 한 번이며, 넘어질 만큼 세게 맞은 핀을 셉니다. 여기서 핀은 미끄러지는 원판이고, 실제 핀은 넘어지면서 다른 핀을 쓸어 넘깁니다. 포켓이 어디에 있고 어떻게 넓어지는지를 읽으십시오. 실제 선수가 스트라이크를 얼마나 자주 치는지를 뜻하지는 않습니다.</translation>
    </message>
    <message>
        <source>Offset from the head pin, to the right [cm]</source>
        <translation>헤드핀에서 오른쪽으로 벗어난 거리 [cm]</translation>
    </message>
    <message>
        <source>Entry angle, to the left [°]</source>
        <translation>입사각 (왼쪽으로) [°]</translation>
    </message>
    <message>
        <source>Speed [m/s]</source>
        <translation>속력 [m/s]</translation>
    </message>
    <message>
        <source>Spin [rpm]</source>
        <translation>회전 [분당 회전수]</translation>
    </message>
    <message>
        <source>Weight of the ball [kg]</source>
        <translation>볼 무게 [kg]</translation>
    </message>
    <message>
        <source>Ball %1 m/s</source>
        <translation>볼 %1 m/s</translation>
    </message>
    <message>
        <source>Ball %1 kg</source>
        <translation>볼 %1 kg</translation>
    </message>
</context>
<context>
    <name>StudyCommandText</name>
    <message>
        <source>Row</source>
        <translation>항목</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>경우</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>물은 것</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>정확한 값</translation>
    </message>
    <message>
        <source>Got</source>
        <translation>얻은 값</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>오차</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>한계 안</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>NO</source>
        <translation>아니오</translation>
    </message>
    <message>
        <source>Within their bounds: %1 of %2</source>
        <translation>한계 안에 든 것: %2개 가운데 %1개</translation>
    </message>
    <message>
        <source>beyond their bounds: %1</source>
        <translation>한계를 벗어난 것: %1</translation>
    </message>
    <message>
        <source>writes the table to a file as well</source>
        <translation>표를 파일에도 씁니다</translation>
    </message>
    <message>
        <source>--csv: needs the name of a file</source>
        <translation>--csv: 파일 이름이 필요합니다</translation>
    </message>
    <message>
        <source>throws: thousands of throws at the rack, by every method; a SCENE: that one; extremes: masses, radii, speeds, places and counts at the edge of what numbers hold, each with its bound</source>
        <translation>throws: 핀 열 개를 향한 수천 번의 투구를 모든 방법으로 계산, SCENE: 그 장면만 계산, extremes: 수가 담을 수 있는 한계의 질량, 반지름, 속력, 위치, 충돌 횟수와 그 오차의 한계</translation>
    </message>
    <message>
        <source>how many throws; 4000 unless said, on the whole lane 1000</source>
        <translation>투구 횟수. 기본값 4000, 레인 전체에서는 1000</translation>
    </message>
    <message>
        <source>of throws: the rack without friction, or the whole lane; rack unless said</source>
        <translation>throws: 마찰이 없는 핀 열 개(rack) 또는 레인 전체(bowling). 기본값 rack</translation>
    </message>
    <message>
        <source>of the throws; 2026 unless said</source>
        <translation>투구를 뽑는 난수의 씨앗값. 기본값 2026</translation>
    </message>
    <message>
        <source>of a SCENE: the time to run [s]; 10 unless said</source>
        <translation>SCENE: 계산할 시간 [s]. 기본값 10</translation>
    </message>
    <message>
        <source>a few, steps down to 1/1000 s, or down to 1/100000 s; standard unless said</source>
        <translation>몇 가지만, 시간 간격 1/1000 s까지, 1/100000 s까지. 기본값 standard</translation>
    </message>
    <message>
        <source>for the errors; all of the machine unless said</source>
        <translation>오차를 잴 때 쓰는 스레드 수. 기본값은 컴퓨터의 모든 코어</translation>
    </message>
    <message>
        <source>draws error against cost</source>
        <translation>계산 시간에 따른 오차를 그림으로 그림</translation>
    </message>
    <message>
        <source>of extremes: ends the longest runs at 100000 collisions, not 10000000</source>
        <translation>extremes: 가장 긴 계산을 충돌 10000000번이 아니라 100000번에서 끝냄</translation>
    </message>
    <message>
        <source>prints the Markdown table of such a file, and studies nothing</source>
        <translation>그런 파일의 표를 Markdown으로 출력하고, 새로 재지 않음</translation>
    </message>
    <message>
        <source>%1 does not take this</source>
        <translation>%1에서는 쓸 수 없는 옵션입니다</translation>
    </message>
    <message>
        <source>must be at most %1, is %2</source>
        <translation>%1 이하여야 합니다. 입력한 값: %2</translation>
    </message>
    <message>
        <source>must be a whole number, is &quot;%1&quot;</source>
        <translation>0 이상의 정수여야 합니다. 입력한 값: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>must end in .png, is &quot;%1&quot;</source>
        <translation>.png로 끝나야 합니다. 입력한 값: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1 throws on the whole lane, seed %2</source>
        <translation>레인 전체에서 투구 %1번, 씨앗값 %2</translation>
    </message>
    <message>
        <source>%1 throws at the rack, seed %2</source>
        <translation>핀 열 개를 향한 투구 %1번, 씨앗값 %2</translation>
    </message>
    <message>
        <source>of throws: between bodies; 0.75 unless said</source>
        <translation>투구의 경우, 물체 사이의 반발 계수. 지정하지 않으면 0.75</translation>
    </message>
</context>
<context>
    <name>StudyMethodsText</name>
    <message>
        <source>the truth …</source>
        <translation>기준 계산 …</translation>
    </message>
    <message>
        <source>costs: round %1 of %2</source>
        <translation>계산 시간: %2번 가운데 %1번째</translation>
    </message>
    <message>
        <source>errors: %1 of %2 cases</source>
        <translation>오차: 경우 %2개 가운데 %1개</translation>
    </message>
    <message>
        <source>cancelled; what was measured by then has been kept</source>
        <translation>도중에 멈추었습니다. 그때까지 잰 것은 남겨 두었습니다</translation>
    </message>
</context>
<context>
    <name>StudyPlotText</name>
    <message>
        <source>cost %1 · error %2 m · same touched %3 %</source>
        <translation>계산 시간 %1 · 오차 %2 m · 같은 핀에 닿음 %3 %</translation>
    </message>
    <message>
        <source>cost of a throw [µs]</source>
        <translation>투구 한 번의 계산 시간 [µs]</translation>
    </message>
    <message>
        <source>cost of a run [µs]</source>
        <translation>한 번의 계산 시간 [µs]</translation>
    </message>
    <message>
        <source>position error at the end, median [m]</source>
        <translation>끝난 때의 위치 오차, 중앙값 [m]</translation>
    </message>
</context>
<context>
    <name>StudyReportText</name>
    <message>
        <source>about %1</source>
        <translation>약 %1</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>계산할 수 없음: %1</translation>
    </message>
    <message>
        <source>too slow, left out</source>
        <translation>너무 느려 제외</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>재지 못함</translation>
    </message>
    <message>
        <source>the truth</source>
        <translation>기준</translation>
    </message>
    <message>
        <source>Truth: %1; studied until %2 s.</source>
        <translation>기준: %1. %2 s까지 쟀습니다.</translation>
    </message>
    <message>
        <source>Too many bodies for 113 bits: the truth is the next-event run itself, and has its errors.</source>
        <translation>물체가 너무 많아 113비트로는 계산하지 않았습니다. 기준은 배정밀도 정확한 계산 자체이며, 그 오차를 그대로 지닙니다.</translation>
    </message>
    <message>
        <source>Digits that chaos leaves of the truth at the last collision, at least: %1</source>
        <translation>마지막 충돌에서 기준 계산에 남은 유효 숫자(혼돈을 거친 뒤): 적어도 %1자리</translation>
    </message>
    <message>
        <source>Digits left of %1: said within one digit of the truth at %2 of %3 collisions.</source>
        <translation>%1의 남은 자릿수: 충돌 %3번 가운데 %2에서 실제와 한 자리 안으로 맞았습니다.</translation>
    </message>
    <message>
        <source>Cancelled: %1 of %2 cases are in this table.</source>
        <translation>도중에 멈춤: 이 표에는 경우 %2개 가운데 %1개가 들어 있습니다.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>a throw</source>
        <translation>투구 한 번</translation>
    </message>
    <message>
        <source>a run</source>
        <translation>계산 한 번</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>퍼짐</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>비</translation>
    </message>
    <message>
        <source>error [m]</source>
        <translation>오차 [m]</translation>
    </message>
    <message>
        <source>rms [m]</source>
        <translation>제곱 평균 제곱근 [m]</translation>
    </message>
    <message>
        <source>same touched</source>
        <translation>같은 핀에 닿음</translation>
    </message>
    <message>
        <source>first difference</source>
        <translation>처음 달라진 충돌</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>에너지</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>놓친 충돌</translation>
    </message>
    <message>
        <source>repeated</source>
        <translation>되풀이한 충돌</translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>충돌</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>뺀 것</translation>
    </message>
    <message>
        <source>its share of the cost</source>
        <translation>시간에서 차지하는 몫</translation>
    </message>
    <message>
        <source>other pins down</source>
        <translation>쓰러진 핀이 다름</translation>
    </message>
    <message>
        <source>other pins touched</source>
        <translation>닿은 핀이 다름</translation>
    </message>
    <message>
        <source>off by [m]</source>
        <translation>위치 차이 [m]</translation>
    </message>
    <message>
        <source>nothing: all models</source>
        <translation>없음: 모두 계산</translation>
    </message>
    <message>
        <source>Cost: processor time on one core, the methods in turn; median, the middle half of the rounds, and the ratio to the first row.</source>
        <translation>시간: 코어 하나에서 방법들을 번갈아 잰 프로세서 시간. 중앙값, 잰 값의 가운데 절반이 차지하는 폭, 첫 행에 대한 비.</translation>
    </message>
    <message>
        <source>Error: rms over the bodies of the distance from where they should be at the end; median and rms over the cases.</source>
        <translation>오차: 끝난 때에 물체들이 있어야 할 곳에서 벗어난 거리의 제곱 평균 제곱근. 모든 경우의 중앙값과 제곱 평균 제곱근.</translation>
    </message>
    <message>
        <source>First difference: the contact that is the first to differ, and its time; median of the cases that differ.</source>
        <translation>처음 달라진 충돌: 몇 번째 충돌부터 다르며 그 시각이 언제인지. 달라진 경우의 중앙값.</translation>
    </message>
    <message>
        <source>Energy: off at the end, of the energy at the start. Missed, repeated: contacts, a case.</source>
        <translation>에너지: 끝난 때의 차이를 처음 에너지로 나눈 값. 놓친 충돌과 되풀이한 충돌: 한 경우의 횟수.</translation>
    </message>
    <message>
        <source>Until %1 s was asked for: the truth does not get there in the time allowed, or chaos has eaten its digits by then.</source>
        <translation>%1 s까지가 요청되었으나, 기준 계산이 정해진 시간 안에 거기까지 이르지 못하거나 그 전에 혼돈으로 유효 숫자를 잃습니다.</translation>
    </message>
</context>
<context>
    <name>StudyTableText</name>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: 읽을 수 없습니다: %2</translation>
    </message>
    <message>
        <source>%1: is not a table that thetalane study --csv wrote</source>
        <translation>%1: thetalane study --csv가 쓴 표가 아닙니다</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Mass ratios</source>
        <translation>질량비</translation>
    </message>
    <message>
        <source>Radius ratios</source>
        <translation>반지름 비</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>반발 계수</translation>
    </message>
    <message>
        <source>Coincident centres</source>
        <translation>겹친 중심</translation>
    </message>
    <message>
        <source>Grazing</source>
        <translation>스치는 접촉</translation>
    </message>
    <message>
        <source>Many collisions</source>
        <translation>많은 충돌</translation>
    </message>
    <message>
        <source>Counting π</source>
        <translation>π 세기</translation>
    </message>
    <message>
        <source>Time reversal</source>
        <translation>시간 되돌리기</translation>
    </message>
    <message>
        <source>Inelastic collapse</source>
        <translation>비탄성 붕괴</translation>
    </message>
    <message>
        <source>Lasting contact</source>
        <translation>지속 접촉</translation>
    </message>
    <message>
        <source>Cost of lasting contact</source>
        <translation>지속 접촉 규칙의 오차</translation>
    </message>
    <message>
        <source>Mirror symmetry</source>
        <translation>거울 대칭</translation>
    </message>
    <message>
        <source>head-on, masses %1 : 1</source>
        <translation>정면충돌, 질량 %1 : 1</translation>
    </message>
    <message>
        <source>glancing, masses %1 : 1</source>
        <translation>비스듬한 충돌, 질량 %1 : 1</translation>
    </message>
    <message>
        <source>radii %1 : 1</source>
        <translation>반지름 %1 : 1</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>%1 m 옮긴 장면</translation>
    </message>
    <message>
        <source>%1 times as large</source>
        <translation>%1배 크기의 장면</translation>
    </message>
    <message>
        <source>e = %1</source>
        <translation>e = %1</translation>
    </message>
    <message>
        <source>a scene with two at one place</source>
        <translation>두 물체의 중심이 같은 장면</translation>
    </message>
    <message>
        <source>centres %1 m apart</source>
        <translation>중심 사이의 거리 %1 m</translation>
    </message>
    <message>
        <source>radii of %1 m</source>
        <translation>반지름 %1 m</translation>
    </message>
    <message>
        <source>%1 m inside</source>
        <translation>%1 m 안쪽</translation>
    </message>
    <message>
        <source>%1 m inside, slanted</source>
        <translation>%1 m 안쪽, 기울어진 방향</translation>
    </message>
    <message>
        <source>%1 m outside</source>
        <translation>%1 m 바깥쪽</translation>
    </message>
    <message>
        <source>%1 m outside, slanted</source>
        <translation>%1 m 바깥쪽, 기울어진 방향</translation>
    </message>
    <message>
        <source>gas in a box, %1 collisions</source>
        <translation>상자 속 기체, 충돌 %1번</translation>
    </message>
    <message>
        <source>open crowd, %1 collisions</source>
        <translation>벽 없는 무리, 충돌 %1번</translation>
    </message>
    <message>
        <source>masses 1 : %1</source>
        <translation>질량 1 : %1</translation>
    </message>
    <message>
        <source>%1 collisions there and back</source>
        <translation>충돌 %1번 갔다가 되돌아옴</translation>
    </message>
    <message>
        <source>three in a line, e = %1</source>
        <translation>일직선의 세 공, e = %1</translation>
    </message>
    <message>
        <source>chain of %1 at a wall, e = 0</source>
        <translation>벽에 닿은 공 %1개의 사슬, e = 0</translation>
    </message>
    <message>
        <source>ball pushes pin, contact time %1 s</source>
        <translation>핀을 미는 공, 접촉 시간 %1 s</translation>
    </message>
    <message>
        <source>pin between two, contact time %1 s</source>
        <translation>두 핀 사이에 낀 핀, 접촉 시간 %1 s</translation>
    </message>
    <message>
        <source>ball spun at a wall, contact time %1 s</source>
        <translation>회전하며 벽에 닿는 공, 접촉 시간 %1 s</translation>
    </message>
    <message>
        <source>ball straight at the rack, e = %1</source>
        <translation>핀 열 개로 곧게 가는 공, e = %1</translation>
    </message>
    <message>
        <source>ball on two, e = %1</source>
        <translation>두 공을 치는 공, e = %1</translation>
    </message>
    <message>
        <source>speed after [m/s]</source>
        <translation>충돌 후 속력 [m/s]</translation>
    </message>
    <message>
        <source>time of contact [s]</source>
        <translation>접촉 시각 [s]</translation>
    </message>
    <message>
        <source>time of contact [s], error in path [m]</source>
        <translation>접촉 시각 [s], 오차는 경로 [m]</translation>
    </message>
    <message>
        <source>line of centres [rad]</source>
        <translation>중심선의 각 [rad]</translation>
    </message>
    <message>
        <source>energy after [J]</source>
        <translation>충돌 후 에너지 [J]</translation>
    </message>
    <message>
        <source>energy loss [J]</source>
        <translation>에너지 손실 [J]</translation>
    </message>
    <message>
        <source>refused (1: yes)</source>
        <translation>거절됨 (1: 예)</translation>
    </message>
    <message>
        <source>they meet (1: yes)</source>
        <translation>만남 (1: 예)</translation>
    </message>
    <message>
        <source>collisions</source>
        <translation>충돌 횟수</translation>
    </message>
    <message>
        <source>collisions, at most</source>
        <translation>충돌 횟수의 상한</translation>
    </message>
    <message>
        <source>stretches of motion, at most</source>
        <translation>운동 구간 수의 상한</translation>
    </message>
    <message>
        <source>energy drift, relative</source>
        <translation>에너지의 상대 변화</translation>
    </message>
    <message>
        <source>momentum drift, relative</source>
        <translation>운동량의 상대 변화</translation>
    </message>
    <message>
        <source>distance from the start [m]</source>
        <translation>처음 위치에서 벗어난 거리 [m]</translation>
    </message>
    <message>
        <source>common velocity [m/s]</source>
        <translation>공통 속도 [m/s]</translation>
    </message>
    <message>
        <source>largest rise of energy, relative</source>
        <translation>에너지의 최대 상대 증가</translation>
    </message>
    <message>
        <source>deepest overlap [m]</source>
        <translation>가장 깊은 겹침 [m]</translation>
    </message>
    <message>
        <source>difference of end positions [m]</source>
        <translation>마지막 위치의 차이 [m]</translation>
    </message>
    <message>
        <source>asymmetry [m, m/s]</source>
        <translation>비대칭 [m, m/s]</translation>
    </message>
</context>
<context>
    <name>ThrowCommandText</name>
    <message>
        <source>of the ball, at most 7.26 kg; 6.8 unless said</source>
        <translation>볼링공의 질량, 최대 7.26 kg. 기본값 6.8</translation>
    </message>
    <message>
        <source>at the foul line; 8 unless said</source>
        <translation>파울 라인에서의 속력. 기본값 8</translation>
    </message>
    <message>
        <source>from straight down the lane, positive to the right; 1.5 unless said</source>
        <translation>레인 방향에서 잰 각도, 오른쪽이 양수. 기본값 1.5</translation>
    </message>
    <message>
        <source>of the ball&apos;s centre at the foul line, from the middle, positive to the right; -0.41 unless said</source>
        <translation>파울 라인에서 공의 중심 위치, 가운데에서 오른쪽이 양수. 기본값 -0.41</translation>
    </message>
    <message>
        <source>of the spin, from a forward roll, positive hooks to the left; 0 unless said</source>
        <translation>앞으로 구르는 방향에서 잰 회전축의 각도, 양수이면 왼쪽으로 훅. 기본값 0</translation>
    </message>
    <message>
        <source>prints JSON for programs</source>
        <translation>프로그램에서 읽을 JSON을 출력합니다</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2개)</translation>
    </message>
    <message>
        <source>Pins down: %1</source>
        <translation>쓰러진 핀: %1</translation>
    </message>
    <message>
        <source>Pins touched: %1</source>
        <translation>맞은 핀: %1</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>스트라이크</translation>
    </message>
    <message>
        <source>revolutions per minute; on a lane with friction the ball hooks; 0 unless said</source>
        <translation>분당 회전수. 마찰이 있는 레인에서 공이 훅을 그립니다. 기본값 0</translation>
    </message>
    <message>
        <source>of a sliding ball on the dry lane; 0.2 unless said</source>
        <translation>드라이 존에서 미끄러지는 공의 마찰 계수. 기본값 0.2</translation>
    </message>
    <message>
        <source>of a sliding ball on the oil; 0.04 unless said</source>
        <translation>오일 위에서 미끄러지는 공의 마찰 계수. 기본값 0.04</translation>
    </message>
    <message>
        <source>of the oil, from the foul line; 12.192 (40 ft) unless said, 0 for none</source>
        <translation>파울 라인에서 잰 오일의 길이, 0이면 오일 없음. 기본값 12.192 (40 ft)</translation>
    </message>
    <message>
        <source>takes all friction away: nothing slows or hooks</source>
        <translation>마찰을 모두 없앱니다. 느려지거나 휘지 않습니다</translation>
    </message>
    <message>
        <source>between bodies; 0.75 unless said</source>
        <translation>물체 사이의 반발 계수. 기본값 0.75</translation>
    </message>
    <message>
        <source>has no meaning with --no-friction; leave one of the two out</source>
        <translation>--no-friction과 함께 쓰면 뜻이 없습니다. 둘 중 하나를 빼십시오</translation>
    </message>
    <message>
        <source>At its first pin: x = %1 m, %2 m/s, heading %3°</source>
        <translation>첫 핀에 닿을 때: x = %1 m, %2 m/s, 방향 %3°</translation>
    </message>
    <message>
        <source>The lane turned its path %1° to the left</source>
        <translation>마찰로 진로가 왼쪽으로 %1° 휘었습니다</translation>
    </message>
    <message>
        <source>The lane turned its path %1° to the right</source>
        <translation>마찰로 진로가 오른쪽으로 %1° 휘었습니다</translation>
    </message>
    <message>
        <source>Without friction the spin has no effect.</source>
        <translation>마찰이 없으면 회전은 결과에 영향을 주지 않습니다.</translation>
    </message>
</context>
<context>
    <name>VaryWords</name>
    <message>
        <source>Weight</source>
        <translation>무게</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Axis of rotation</source>
        <translation>회전축</translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>no display answers; thetalane --help lists the commands that need none</source>
        <translation>창을 띄울 화면(디스플레이)이 없습니다. 화면 없이 쓸 수 있는 명령은 thetalane --help에서 볼 수 있습니다</translation>
    </message>
    <message>
        <source>%1: this game cannot be read</source>
        <translation>%1: 게임 파일을 읽을 수 없습니다</translation>
    </message>
</context>
<context>
    <name>WorkedSteps</name>
    <message>
        <source>The centres coincide, so there is no line of centres; θ = 0 is taken by rule.</source>
        <translation>두 중심이 겹쳐 중심선을 정할 수 없으므로, 약속에 따라 θ = 0으로 합니다.</translation>
    </message>
    <message>
        <source>The bodies touch when the distance Z between their centres is no longer greater than the sum of the radii; the triangle a, b, Z gives the direction θ of the line of centres.</source>
        <translation>두 물체는 중심 사이의 거리 Z가 반지름의 합 이하일 때 맞닿습니다. 직각삼각형 a, b, Z에서 중심선의 방향 θ를 구합니다.</translation>
    </message>
    <message>
        <source>Each velocity is an arrow; it is split into a component along x and one along y.</source>
        <translation>속도는 화살표로 나타낼 수 있으며, 이를 x 성분과 y 성분으로 분해합니다.</translation>
    </message>
    <message>
        <source>The axes are turned by θ, so that x′ lies on the line of centres and y′ across it; the velocities stay as they are, only their components are new.</source>
        <translation>좌표축을 θ만큼 회전하여 x′축은 중심선에, y′축은 그에 수직인 방향에 놓습니다. 속도는 그대로이고 성분만 달라집니다.</translation>
    </message>
    <message>
        <source>Against an infinite mass the velocity along x′ turns round and keeps the fraction e; along the frictionless wall, y′, no force acts, so nothing changes there.</source>
        <translation>벽의 질량이 무한대이므로 x′ 방향의 속도는 방향이 반대로 바뀌고 크기는 e배가 됩니다. 벽에는 마찰이 없어 벽과 나란한 y′ 방향으로는 힘이 작용하지 않으므로 y′ 성분은 변하지 않습니다.</translation>
    </message>
    <message>
        <source>With e = 0 both leave at the same velocity along x′; without friction the force acts along the line of centres only, so y′ does not change.</source>
        <translation>e = 0이므로 충돌 후 두 물체의 x′ 방향 속도는 같습니다. 마찰이 없으면 힘은 중심선을 따라서만 작용하므로 y′ 성분은 변하지 않습니다.</translation>
    </message>
    <message>
        <source>Without friction the force acts along the line of centres only: along x′ it is a collision in one dimension, and across it, y′, nothing changes.</source>
        <translation>마찰이 없으면 힘은 중심선을 따라서만 작용합니다. 그래서 x′ 방향은 1차원 충돌이 되고, 그에 수직인 y′ 방향의 속도는 변하지 않습니다.</translation>
    </message>
    <message>
        <source>The axes are turned back by θ, and the new components are read along x and y again.</source>
        <translation>좌표축을 θ만큼 되돌려, 충돌 후의 속도를 다시 x 성분과 y 성분으로 환산합니다.</translation>
    </message>
    <message>
        <source>The total momentum is the same before and after, and at e = 1 so is the kinetic energy.</source>
        <translation>충돌 전후에 운동량의 합은 보존되며, e = 1이므로 운동 에너지의 합도 보존됩니다.</translation>
    </message>
    <message>
        <source>The total momentum is the same before and after; kinetic energy is lost along x′ only.</source>
        <translation>충돌 전후에 운동량의 합은 보존되며, 운동 에너지는 x′ 방향의 몫만 줄어듭니다.</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>접촉</translation>
    </message>
    <message>
        <source>Velocity split</source>
        <translation>속도의 분해</translation>
    </message>
    <message>
        <source>Rotation by θ</source>
        <translation>좌표축의 회전 (θ)</translation>
    </message>
    <message>
        <source>Exchange along x′</source>
        <translation>x′축의 1차원 충돌</translation>
    </message>
    <message>
        <source>Rotation back</source>
        <translation>역회전</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>These two were already moving apart; the paper&apos;s loop exchanges every overlapping pair all the same, and so drives them back together.</source>
        <translation>두 물체는 이미 멀어지고 있었습니다. 그런데도 논문의 반복 계산은 겹친 쌍을 모두 충돌로 처리하므로 두 물체를 다시 가까워지게 합니다.</translation>
    </message>
    <message>
        <source>The wall takes up the impulse, so the body&apos;s own momentum changes; what must hold is the ratio e of the speeds along x′.</source>
        <translation>벽에서 충격량을 받으므로 물체의 운동량은 변합니다. 여기서는 x′ 방향 속력의 비가 e인지 확인합니다.</translation>
    </message>
    <message>
        <source>The wall W counts as a second body of infinite mass at rest; the line of centres stands square on it.</source>
        <translation>벽 W는 질량이 무한대이고 정지해 있는 둘째 물체로 봅니다. 중심선은 벽에 수직입니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n contacts are resolved together: their impulses are found all at once, so that each contact keeps its own law of restitution along its own line of centres, and impulses that meet on a body add up.</source>
        <translation>
            <numerusform>접촉 %n개를 함께 계산합니다. 각 접촉이 자신의 중심선을 따라 반발 계수 식을 만족하도록 모든 충격량을 한꺼번에 구하며, 한 물체에 모이는 충격량은 더해집니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Here the other impulses part the two faster than e asks.</source>
        <translation>여기서는 다른 접촉의 충격량이 두 물체를 e로 정해지는 것보다 더 빠르게 떼어 놓습니다.</translation>
    </message>
    <message>
        <source>An impulse along another line strikes %1 too, so y′ changes there as well.</source>
        <translation>다른 중심선을 따라 작용하는 충격량을 %1도 받으므로, 그 y′ 성분도 변합니다.</translation>
    </message>
    <message>
        <source>Of contacts resolved together it is the momentum of them all that must be the same, every body counted once; the law of restitution holds at each contact.</source>
        <translation>함께 계산한 접촉에서는 관련된 모든 물체를 한 번씩 더한 운동량의 합이 보존되어야 합니다. 반발 계수 식은 접촉마다 성립합니다.</translation>
    </message>
    <message>
        <source>A wall is among them: it takes up an impulse, and by just that the momentum changes.</source>
        <translation>그 가운데 벽과의 접촉이 있습니다. 벽이 주고받은 충격량만큼 운동량이 변합니다.</translation>
    </message>
</context>
<context>
    <name>Worksheet</name>
    <message>
        <source>Worksheet: bodies that collide at once</source>
        <translation>활동지: 여러 물체의 동시 충돌</translation>
    </message>
    <message>
        <source>Worksheet: collision with a wall</source>
        <translation>활동지: 벽과의 충돌</translation>
    </message>
    <message>
        <source>Worksheet: collision of two bodies</source>
        <translation>활동지: 두 물체의 충돌</translation>
    </message>
    <message>
        <source>Find θ, the direction of the line square on the wall (x′).</source>
        <translation>벽에 수직인 법선 방향(x′축)의 각 θ를 구하시오.</translation>
    </message>
    <message>
        <source>Find θ, the direction of the line of centres (x′).</source>
        <translation>두 물체의 중심선(x′축)이 x축과 이루는 각 θ를 구하시오.</translation>
    </message>
    <message>
        <source>Split the velocities before the collision along x′ and across it, y′.</source>
        <translation>충돌 전 속도를 x′ 성분과 y′ 성분으로 분해하시오.</translation>
    </message>
    <message>
        <source>Along x′ it is a collision in one dimension: find the components after it.</source>
        <translation>x′ 방향의 1차원 충돌에서 충돌 후의 속도 성분을 구하시오.</translation>
    </message>
    <message>
        <source>Turn back to x and y: find the velocities after the collision.</source>
        <translation>원래의 x축과 y축으로 환산하여 충돌 후 속도를 구하시오.</translation>
    </message>
    <message>
        <source>Fill in the blanks of the table.</source>
        <translation>표의 빈칸을 채우시오.</translation>
    </message>
    <message>
        <source>Check the coefficient of restitution, the energy and the momentum.</source>
        <translation>반발 계수, 에너지 손실, 운동량 보존을 확인하시오.</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>정답과 풀이</translation>
    </message>
    <message>
        <source>Collision %1: %2, at %3 s</source>
        <translation>충돌 %1: %2, 시각 %3 s</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>학년 · 반 · 번호</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>What is given</source>
        <translation>주어진 값</translation>
    </message>
    <message>
        <source>Is the total momentum the same before and after the collision? Why?</source>
        <translation>충돌 전과 충돌 후의 총 운동량은 같은가? 그 까닭은 무엇인가?</translation>
    </message>
    <message>
        <source>No: the wall takes up an impulse, and by just that the momentum of the bodies changes.</source>
        <translation>같지 않다. 벽이 충격량을 받고, 바로 그만큼 물체의 운동량이 변한다.</translation>
    </message>
    <message>
        <source>Yes: only the bodies act on each other, with forces equal and opposite, so the total momentum is kept.</source>
        <translation>같다. 물체끼리 크기가 같고 방향이 반대인 힘(작용 반작용)만 주고받으므로 총 운동량이 보존된다.</translation>
    </message>
    <message>
        <source>Before the collision</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>After the collision</source>
        <translation>충돌 후</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>합계</translation>
    </message>
</context>
<context>
    <name>WorksheetCommand</name>
    <message>
        <source>is missing; say where the worksheet goes, FILE.pdf</source>
        <translation>없습니다. 활동지를 저장할 파일을 FILE.pdf처럼 지정하십시오</translation>
    </message>
    <message>
        <source>must end in .pdf, is &quot;%1&quot;</source>
        <translation>.pdf로 끝나야 하는데 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>where the worksheet goes</source>
        <translation>활동지를 저장할 파일</translation>
    </message>
    <message>
        <source>which collision, from 1; the first unless said</source>
        <translation>몇 번째 충돌인지 (1부터). 기본값은 첫 번째</translation>
    </message>
    <message>
        <source>%1: nothing collides in this scene in the time asked for</source>
        <translation>%1: 이 장면에서는 지정한 시간 안에 충돌이 일어나지 않습니다</translation>
    </message>
    <message>
        <source>must be from 1 to %1, the number of collisions, is %2</source>
        <translation>1부터 충돌 횟수 %1까지여야 하는데 %2입니다</translation>
    </message>
</context>
<context>
    <name>thetalane::AimTool</name>
    <message>
        <source>%1° to the right</source>
        <translation>오른쪽으로 %1°</translation>
    </message>
    <message>
        <source>%1° to the left</source>
        <translation>왼쪽으로 %1°</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>똑바로</translation>
    </message>
    <message>
        <source>%1, over board %2</source>
        <translation>%1, 보드 %2번 위</translation>
    </message>
    <message>
        <source>no rotation</source>
        <translation>회전 없음</translation>
    </message>
    <message>
        <source>%1, forward roll</source>
        <translation>%1, 앞으로 구르는 회전</translation>
    </message>
    <message>
        <source>%1, axis %2°, hooks left</source>
        <translation>%1, 축 %2°, 왼쪽 훅</translation>
    </message>
    <message>
        <source>%1, axis %2°, hooks right</source>
        <translation>%1, 축 %2°, 오른쪽 훅</translation>
    </message>
    <message>
        <source>%1 m, board %2</source>
        <translation>%1 m, 보드 %2번</translation>
    </message>
    <message>
        <source>The ball&apos;s centre stays on the lane</source>
        <translation>볼링공의 중심은 레인을 벗어날 수 없습니다</translation>
    </message>
    <message>
        <source>By hand up to %1°; more can be typed</source>
        <translation>끌어서는 %1°까지이며, 그 이상은 숫자로 입력합니다</translation>
    </message>
    <message>
        <source>By hand not below %1; less can be typed</source>
        <translation>끌어서는 %1까지이며, 그보다 작은 값은 숫자로 입력합니다</translation>
    </message>
    <message>
        <source>By hand up to %1; more can be typed</source>
        <translation>끌어서는 %1까지이며, 그 이상은 숫자로 입력합니다</translation>
    </message>
    <message>
        <source>By hand up to %1 rpm; more can be typed</source>
        <translation>끌어서는 분당 %1회전까지이며, 그 이상은 숫자로 입력합니다</translation>
    </message>
    <message>
        <source>±90° is side spin alone; more would turn backwards</source>
        <translation>±90°는 옆 회전뿐이며, 더 돌리면 거꾸로 도는 회전이 됩니다</translation>
    </message>
    <message>
        <source>Shift: fine. A and the arrow keys do the same. Esc: as before.</source>
        <translation>Shift: 세밀하게. A 키와 화살표 키로도 조절할 수 있습니다. Esc: 되돌리기.</translation>
    </message>
    <message>
        <source>Drag the ball along the foul line.</source>
        <translation>볼링공을 파울 라인을 따라 끌어 옮깁니다.</translation>
    </message>
    <message>
        <source>Drag the tip to aim.</source>
        <translation>화살표 끝을 끌어 방향을 정합니다.</translation>
    </message>
    <message>
        <source>Drag along the arrow: the speed.</source>
        <translation>화살표를 따라 끌면 속력이 바뀝니다.</translation>
    </message>
    <message>
        <source>Drag round the ball: the axis; outwards: more rotation.</source>
        <translation>공 둘레로 끌면 회전축이 바뀌고, 바깥으로 끌수록 회전이 빨라집니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::BodiesPage</name>
    <message>
        <source>All bodies now</source>
        <translation>지금의 모든 물체</translation>
    </message>
    <message>
        <source>Follows the time; Ctrl+C copies the rows chosen, or all, with every digit</source>
        <translation>시각을 따라 바뀝니다. Ctrl+C를 누르면 선택한 행(없으면 전체)을 모든 자릿수로 복사합니다</translation>
    </message>
    <message>
        <source>At %1 s</source>
        <translation>시각 %1 s</translation>
    </message>
</context>
<context>
    <name>thetalane::BodiesPanel</name>
    <message>
        <source>Coefficient of restitution e</source>
        <translation>반발 계수 e</translation>
    </message>
    <message>
        <source>0: perfectly inelastic, 1: elastic. Between all bodies.</source>
        <translation>0은 완전 비탄성 충돌, 1은 탄성 충돌입니다. 모든 물체 사이에 적용됩니다.</translation>
    </message>
    <message>
        <source>Shown are the first %1 of %2 bodies.</source>
        <translation>물체 %2개 중 처음 %1개만 표시합니다.</translation>
    </message>
    <message>
        <source>Add a body</source>
        <translation>물체 추가</translation>
    </message>
    <message>
        <source>One body more, at rest, where there is room</source>
        <translation>빈 자리에 정지한 물체를 하나 더 놓습니다</translation>
    </message>
    <message>
        <source>%1 bodies are the most that are edited by hand</source>
        <translation>직접 편집할 수 있는 물체는 최대 %1개입니다</translation>
    </message>
    <message>
        <source>There is no room for another body; move the walls or make the bodies smaller.</source>
        <translation>물체를 더 놓을 자리가 없습니다. 벽을 옮기거나 물체를 작게 하십시오.</translation>
    </message>
    <message>
        <source>There is no room for all bodies on one line; move the walls or make the bodies smaller.</source>
        <translation>모든 물체를 한 직선 위에 놓을 자리가 없습니다. 벽을 옮기거나 물체를 작게 하십시오.</translation>
    </message>
</context>
<context>
    <name>thetalane::BodyGroup</name>
    <message>
        <source>Mass</source>
        <translation>질량</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>반지름</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>위치 x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>위치 y</translation>
    </message>
    <message>
        <source>Mass of this body, greater than 0</source>
        <translation>이 물체의 질량. 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>Radius of this body, greater than 0</source>
        <translation>이 물체의 반지름. 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>Speed of this body, 0 or more</source>
        <translation>이 물체의 속력. 0 이상이어야 합니다.</translation>
    </message>
    <message>
        <source>Direction of motion, counter-clockwise from x</source>
        <translation>운동 방향. x축에서 시계 반대 방향으로 잽니다.</translation>
    </message>
    <message>
        <source>Where the centre is, to the right</source>
        <translation>중심의 위치. 오른쪽이 양의 방향입니다.</translation>
    </message>
    <message>
        <source>Where the centre is, upwards</source>
        <translation>중심의 위치. 위쪽이 양의 방향입니다.</translation>
    </message>
    <message>
        <source>must be 0 or more, is %1</source>
        <translation>0 이상이어야 합니다. 지금 값: %1</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Spin x</source>
        <translation>각속도 x</translation>
    </message>
    <message>
        <source>Spin y</source>
        <translation>각속도 y</translation>
    </message>
    <message>
        <source>Spin z</source>
        <translation>각속도 z</translation>
    </message>
    <message>
        <source>Moment of inertia β</source>
        <translation>관성 모멘트 β</translation>
    </message>
    <message>
        <source>Angular velocity about x; negative rolls up the screen</source>
        <translation>x축 둘레의 각속도. 음수이면 화면 위쪽으로 구르는 회전입니다.</translation>
    </message>
    <message>
        <source>Angular velocity about y; positive rolls to the right</source>
        <translation>y축 둘레의 각속도. 양수이면 오른쪽으로 구르는 회전입니다.</translation>
    </message>
    <message>
        <source>Angular velocity about the vertical, counter-clockwise; it does not bend the path</source>
        <translation>연직축 둘레의 각속도(시계 반대 방향). 경로를 휘게 하지 않습니다.</translation>
    </message>
    <message>
        <source>β = I/(m R²), greater than 0, at most 1; 0.4 for a uniform sphere</source>
        <translation>β = I/(m R²). 0보다 크고 1 이하여야 하며, 균일한 구는 0.4입니다.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Velocity along x; negative: to the left</source>
        <translation>x 방향 속도. 음수이면 왼쪽으로 움직입니다</translation>
    </message>
    <message>
        <source>Name of this body; each has its own</source>
        <translation>이 물체의 이름. 서로 달라야 합니다</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>공</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>핀</translation>
    </message>
    <message>
        <source>Ball or pin: they look different; on a floor with friction balls roll</source>
        <translation>공 또는 핀. 모양이 다르며, 마찰이 있는 바닥에서 공은 구릅니다</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 삭제</translation>
    </message>
</context>
<context>
    <name>thetalane::CentreFigure</name>
    <message>
        <source>Path of the centre of mass</source>
        <translation>질량 중심의 경로</translation>
    </message>
    <message>
        <source>The cross is the centre of mass; solid: where it has been, dotted: where it goes</source>
        <translation>십자가 질량 중심입니다. 실선은 지나온 길, 점선은 앞으로 갈 길입니다</translation>
    </message>
</context>
<context>
    <name>thetalane::CentrePage</name>
    <message>
        <source>Centre of mass</source>
        <translation>질량 중심</translation>
    </message>
    <message>
        <source>Follows the time; Ctrl+C copies it with every digit</source>
        <translation>시각을 따라 바뀝니다. Ctrl+C를 누르면 모든 자릿수로 복사합니다</translation>
    </message>
</context>
<context>
    <name>thetalane::CollisionList</name>
    <message>
        <source>Collisions</source>
        <translation>충돌 목록</translation>
    </message>
    <message>
        <source>Click a row to open that collision; Ctrl+C copies the rows with every digit</source>
        <translation>행을 누르면 그 충돌이 열립니다. Ctrl+C를 누르면 고른 행을 모든 자릿수로 복사합니다.</translation>
    </message>
    <message>
        <source>Nothing collides in this scene.</source>
        <translation>이 장면에서는 충돌이 일어나지 않습니다.</translation>
    </message>
    <message>
        <source>The collisions before these</source>
        <translation>이전 충돌 목록</translation>
    </message>
    <message>
        <source>The collisions after these</source>
        <translation>다음 충돌 목록</translation>
    </message>
    <message>
        <source>Collisions %1 to %2 of %3</source>
        <translation>충돌 %1–%2 / %3</translation>
    </message>
    <message>
        <source>Collisions %1 to %2</source>
        <translation>충돌 %1–%2</translation>
    </message>
</context>
<context>
    <name>thetalane::CollisionModel</name>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>Time of the collision, in seconds</source>
        <translation>충돌 시각(초)</translation>
    </message>
    <message>
        <source>First body → second body, or the wall</source>
        <translation>첫째 물체 → 둘째 물체 또는 벽</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>충격량</translation>
    </message>
    <message>
        <source>Impulse on the first body along x′, in newton seconds</source>
        <translation>첫째 물체가 x′ 방향으로 받은 충격량(뉴턴초)</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>손실</translation>
    </message>
    <message>
        <source>Kinetic energy lost, in joules</source>
        <translation>운동 에너지 손실(줄)</translation>
    </message>
    <message>
        <source>First</source>
        <translation>첫째</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>둘째</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
    <message>
        <source>Same instant</source>
        <translation>같은 순간</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>충돌한 물체</translation>
    </message>
    <message>
        <source>Number of the collision. A bracket joins those of the same instant, a bar beside it those that were resolved together.</source>
        <translation>충돌의 번호. 같은 순간에 일어난 충돌은 괄호로, 그중 함께 계산한 것은 그 옆의 굵은 막대로 묶었습니다.</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>회차</translation>
    </message>
</context>
<context>
    <name>thetalane::CollisionPage</name>
    <message>
        <source>No collision is open: these are all bodies now.</source>
        <translation>열린 충돌이 없어 지금의 모든 물체를 보입니다.</translation>
    </message>
    <message>
        <source>All digits on hover; Ctrl+C copies the rows chosen, or all, with every digit</source>
        <translation>마우스를 올리면 모든 자릿수가 보입니다. Ctrl+C를 누르면 선택한 행(없으면 전체)을 모든 자릿수로 복사합니다</translation>
    </message>
    <message>
        <source>Before and after the collision</source>
        <translation>충돌 전과 충돌 후</translation>
    </message>
    <message>
        <source>Checks of the collision</source>
        <translation>충돌의 확인</translation>
    </message>
    <message>
        <source>Collision %1 of %2: %3, at %4 s</source>
        <translation>충돌 %1/%2: %3, %4 s</translation>
    </message>
</context>
<context>
    <name>thetalane::CollisionTreePanel</name>
    <message>
        <source>Nobody hits anybody.</source>
        <translation>부딪치는 물체가 없습니다.</translation>
    </message>
    <message>
        <source>Above an arrow the time [s], below it the impulse [N·s]. What has not happened yet is grey; click an arrow to open the collision.</source>
        <translation>화살표 위는 시각 [s], 아래는 충격량 [N·s]입니다. 아직 일어나지 않은 충돌은 회색이며, 화살표를 누르면 그 충돌이 열립니다.</translation>
    </message>
    <message>
        <source>Click an arrow, or go along them with the arrow keys, to open the collision</source>
        <translation>화살표를 누르거나 화살표 키로 따라가면 그 충돌이 열립니다</translation>
    </message>
    <message>
        <source>Left standing</source>
        <translation>남은 핀</translation>
    </message>
    <message>
        <source>Later hits</source>
        <translation>그 뒤의 충돌</translation>
    </message>
    <message>
        <source>Hits of bodies that moved already; choose one to open it</source>
        <translation>이미 움직이던 물체끼리의 충돌입니다. 고르면 열립니다</translation>
    </message>
    <message>
        <source>Perfect strike, right-handed: the ball touches only 1, 3, 5 and 9, and the pins do the rest: 1 → 2 → 4 → 7, 3 → 6 → 10, 5 → 8.</source>
        <translation>퍼펙트 스트라이크(오른손): 공은 1, 3, 5, 9번 핀만 맞히고 나머지는 핀이 핀을 쓰러뜨립니다. 1 → 2 → 4 → 7, 3 → 6 → 10, 5 → 8.</translation>
    </message>
    <message>
        <source>Perfect strike, left-handed: the ball touches only 1, 2, 5 and 8, and the pins do the rest: 1 → 3 → 6 → 10, 2 → 4 → 7, 5 → 9.</source>
        <translation>퍼펙트 스트라이크(왼손): 공은 1, 2, 5, 8번 핀만 맞히고 나머지는 핀이 핀을 쓰러뜨립니다. 1 → 3 → 6 → 10, 2 → 4 → 7, 5 → 9.</translation>
    </message>
    <message>
        <source>Of the ten links of the perfect strike, right-handed, %1 came about (amber).</source>
        <translation>퍼펙트 스트라이크(오른손)의 고리 10개 가운데 %1개가 이루어졌습니다(주황색).</translation>
    </message>
    <message>
        <source>Of the ten links of the perfect strike, left-handed, %1 came about (amber).</source>
        <translation>퍼펙트 스트라이크(왼손)의 고리 10개 가운데 %1개가 이루어졌습니다(주황색).</translation>
    </message>
    <message>
        <source>Drawn are the first %1 hits that set a body moving; %2 more are not.</source>
        <translation>물체를 처음 움직인 충돌 가운데 앞의 %1개만 그렸습니다. %2개가 더 있습니다.</translation>
    </message>
    <message>
        <source>Listed are the first %1 later hits.</source>
        <translation>그 뒤의 충돌은 앞의 %1개만 적었습니다.</translation>
    </message>
    <message>
        <source>Only the first %1 of %2 collisions were looked at.</source>
        <translation>충돌 %2개 가운데 앞의 %1개만 살펴보았습니다.</translation>
    </message>
    <message>
        <source>No pin is left standing.</source>
        <translation>남은 핀이 없습니다.</translation>
    </message>
    <message>
        <source>Left standing: %1</source>
        <translation>남은 핀: %1</translation>
    </message>
    <message>
        <source>Touched, but too softly to tip: %1</source>
        <translation>닿았지만 약해서 넘어지지 않음: %1</translation>
    </message>
    <message>
        <source>Later hits: %1</source>
        <translation>그 뒤의 충돌: %1개</translation>
    </message>
</context>
<context>
    <name>thetalane::CoursePage</name>
    <message>
        <source>Press or drag to move the time</source>
        <translation>누르거나 끌면 시각이 바뀝니다</translation>
    </message>
    <message>
        <source>Kinetic energy of all bodies over time</source>
        <translation>시간에 따른 모든 물체의 운동 에너지</translation>
    </message>
    <message>
        <source>Momentum of all bodies over time</source>
        <translation>시간에 따른 모든 물체의 운동량</translation>
    </message>
    <message>
        <source>Kinetic energy of all bodies</source>
        <translation>모든 물체의 운동 에너지</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>시각 [s]</translation>
    </message>
    <message>
        <source>Momentum of all bodies</source>
        <translation>모든 물체의 운동량</translation>
    </message>
    <message>
        <source>%1 moments, evenly spaced, stand for more events than that.</source>
        <translation>사건이 너무 많아 같은 간격의 %1개 시점만 나타냈습니다.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
</context>
<context>
    <name>thetalane::EditOptionsRow</name>
    <message>
        <source>Constant size</source>
        <translation>크기 고정</translation>
    </message>
    <message>
        <source>On: a new mass leaves the radius as it is. Off: the radius follows the mass at the same density, by its cube root.</source>
        <translation>켜면 질량을 바꾸어도 반지름이 그대로입니다. 끄면 밀도가 일정하도록 반지름이 질량의 세제곱근에 비례하여 바뀝니다.</translation>
    </message>
    <message>
        <source>One line (1-D)</source>
        <translation>한 직선 (1차원)</translation>
    </message>
    <message>
        <source>All bodies on one line along x, with velocities along it only</source>
        <translation>모든 물체를 x축과 나란한 한 직선 위에 놓고, 속도도 그 방향으로만 줍니다</translation>
    </message>
    <message>
        <source>Snap to grid</source>
        <translation>격자에 맞춤</translation>
    </message>
    <message>
        <source>Bodies are put down on the grid, arrows on tenths of a m/s; Ctrl turns it round while dragging</source>
        <translation>물체는 격자에, 화살표는 0.1 m/s 단위에 맞춥니다. 끄는 동안 Ctrl을 누르면 반대가 됩니다</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>격자 간격</translation>
    </message>
    <message>
        <source>By zoom</source>
        <translation>배율에 따라</translation>
    </message>
</context>
<context>
    <name>thetalane::EditTool</name>
    <message>
        <source>Drag: set the velocity of %1</source>
        <translation>끌기: %1의 속도를 정합니다</translation>
    </message>
    <message>
        <source>Keys: N selects a body, Alt and the arrow keys change its velocity</source>
        <translation>키: N으로 물체를 고르고, Alt와 방향키로 속도를 바꿉니다</translation>
    </message>
    <message>
        <source>Drag: move it</source>
        <translation>끌기: 옮깁니다</translation>
    </message>
    <message>
        <source>Keys: N selects a body, the arrow keys move it, Delete removes it</source>
        <translation>키: N으로 물체를 고르고, 방향키로 옮기고, Delete로 삭제합니다</translation>
    </message>
</context>
<context>
    <name>thetalane::EngineChooser</name>
    <message>
        <source>Way of computing</source>
        <translation>계산 방식</translation>
    </message>
    <message>
        <source>Exact (next event)</source>
        <translation>정확한 계산 (다음 충돌)</translation>
    </message>
    <message>
        <source>Paper&apos;s loop, %1, approaching only</source>
        <translation>논문의 반복 계산, %1, 다가갈 때만</translation>
    </message>
    <message>
        <source>Paper&apos;s loop, %1</source>
        <translation>논문의 반복 계산, %1</translation>
    </message>
    <message>
        <source>How contacts are found: exactly, from one to the next; by the paper&apos;s loop, which moves everything by a fixed step and then tests for overlap; or by swept steps, which look for the instant of contact within a step, but see what a body hits next only in the step after</source>
        <translation>접촉을 찾는 방식. 다음 충돌의 시각을 바로 구하거나, 논문의 반복 계산처럼 일정한 시간 간격마다 물체를 옮긴 뒤 겹쳤는지 검사합니다. 연속 충돌 검사는 시간 간격 안에서 충돌하는 순간을 구하지만, 충돌한 물체가 이어서 무엇에 부딪히는지는 다음 간격에서야 살핍니다.</translation>
    </message>
    <message>
        <source>Next event, one contact at a time</source>
        <translation>다음 충돌, 접촉을 하나씩</translation>
    </message>
    <message>
        <source>Swept steps, %1</source>
        <translation>연속 충돌 검사, %1</translation>
    </message>
    <message>
        <source>Swept steps, %1, passes: %2</source>
        <translation>연속 충돌 검사, %1, 탐색 %2회</translation>
    </message>
</context>
<context>
    <name>thetalane::FileBar</name>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>New, open, save</source>
        <translation>새로 만들기, 열기, 저장</translation>
    </message>
    <message>
        <source>New</source>
        <translation>새로 만들기</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>열기…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>최근 파일</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>실행 취소</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>실행 취소: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>다시 실행</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>다시 실행: %1</translation>
    </message>
    <message>
        <source>%1 (not found)</source>
        <translation>%1 (찾을 수 없음)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>아직 없음</translation>
    </message>
    <message>
        <source>Forget these files</source>
        <translation>최근 파일 목록 지우기</translation>
    </message>
</context>
<context>
    <name>thetalane::FileFlow</name>
    <message>
        <source>Unsaved changes</source>
        <translation>저장하지 않은 변경</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved.</source>
        <translation>장면에 저장하지 않은 변경이 있습니다.</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>“%1”에 저장하지 않은 변경이 있습니다.</translation>
    </message>
    <message>
        <source>Without saving, the changes are lost.</source>
        <translation>저장하지 않으면 변경한 내용이 사라집니다.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>저장 안 함</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>장면 저장</translation>
    </message>
    <message>
        <source>Scene files (*.json)</source>
        <translation>장면 파일 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>모든 파일 (*)</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>장면 파일 열기</translation>
    </message>
</context>
<context>
    <name>thetalane::Floor</name>
    <message>
        <source>oil, μ = %1</source>
        <translation>오일, μ = %1</translation>
    </message>
</context>
<context>
    <name>thetalane::FormulaView</name>
    <message>
        <source>Formulas of this step</source>
        <translation>이 단계의 식</translation>
    </message>
    <message>
        <source>Copy this line</source>
        <translation>이 줄 복사</translation>
    </message>
    <message>
        <source>Copy all lines</source>
        <translation>모든 줄 복사</translation>
    </message>
</context>
<context>
    <name>thetalane::FrameEditor</name>
    <message>
        <source>Rolls of the frame</source>
        <translation>프레임의 투구</translation>
    </message>
    <message>
        <source>The rolls as they stand on a score sheet</source>
        <translation>점수판에 적는 대로 쓴 투구</translation>
    </message>
    <message>
        <source>X strike, / spare, - none, F foul; or click the pins that fell.</source>
        <translation>X 스트라이크, / 스페어, - 없음, F 파울. 쓰러진 핀을 눌러도 됩니다.</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>고치기</translation>
    </message>
    <message>
        <source>Puts the frame right and marks it as corrected</source>
        <translation>프레임을 고치고, 고친 것으로 표시합니다</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Leaves the frame as it is (Esc)</source>
        <translation>프레임을 그대로 둡니다 (Esc)</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, %2프레임</translation>
    </message>
    <message>
        <source>Correction by hand</source>
        <translation>직접 고치기</translation>
    </message>
    <message>
        <source>Ball %1</source>
        <translation>%1구</translation>
    </message>
    <message>
        <source>Ball %1: %2</source>
        <translation>%1구: %2</translation>
    </message>
    <message>
        <source>Ball %1: %2, pins not known</source>
        <translation>%1구: %2, 핀 번호 모름</translation>
    </message>
</context>
<context>
    <name>thetalane::GamePanel</name>
    <message>
        <source>Bowling game</source>
        <translation>볼링 게임</translation>
    </message>
</context>
<context>
    <name>thetalane::GhostBox</name>
    <message>
        <source>The same throw under each method; a mark stands where one leaves the truth</source>
        <translation>방법마다 계산한 같은 투구. 참값에서 벗어나는 곳에 표시가 있습니다</translation>
    </message>
    <message>
        <source>The same throw under each method will be drawn here.</source>
        <translation>같은 투구를 방법마다 계산해 여기에 그립니다.</translation>
    </message>
    <message>
        <source>Time of the drawing</source>
        <translation>그림의 시각</translation>
    </message>
    <message>
        <source>Moves all of them through the time</source>
        <translation>그림 전체의 시각을 옮깁니다</translation>
    </message>
    <message>
        <source>Press to go to that instant</source>
        <translation>누르면 그 순간으로 갑니다</translation>
    </message>
    <message>
        <source>Grey: what should happen. Choose a line or a mark to see where it leaves.</source>
        <translation>회색은 참값입니다. 줄이나 표시를 고르면 어디서 벗어나는지 보입니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::GuessFields</name>
    <message>
        <source>after the collision, as you expect it</source>
        <translation>예측하는 충돌 후의 값</translation>
    </message>
    <message>
        <source>Speed of %1</source>
        <translation>%1의 속력</translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation>%1의 방향</translation>
    </message>
    <message>
        <source>from the x axis, counterclockwise, as you expect it</source>
        <translation>예측하는 방향, x축에서 시계 반대 방향으로 잰 각</translation>
    </message>
    <message>
        <source>As speed and direction</source>
        <translation>속력과 방향으로 입력</translation>
    </message>
    <message>
        <source>How the velocities are typed</source>
        <translation>속도를 입력하는 방법</translation>
    </message>
    <message>
        <source>Predict the momentum of both together after the collision</source>
        <translation>충돌 후 두 물체의 운동량의 합도 예측합니다</translation>
    </message>
    <message>
        <source>Energy lost too</source>
        <translation>에너지 손실도 예측</translation>
    </message>
    <message>
        <source>Predict how much kinetic energy the collision takes</source>
        <translation>충돌로 줄어드는 운동 에너지도 예측합니다</translation>
    </message>
    <message>
        <source>Total momentum, x</source>
        <translation>운동량의 합, x</translation>
    </message>
    <message>
        <source>Of both together, after the collision</source>
        <translation>충돌 후 두 물체의 합</translation>
    </message>
    <message>
        <source>Total momentum, y</source>
        <translation>운동량의 합, y</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Total momentum too: x, y [kg·m/s]</source>
        <translation>운동량의 합도 예측: x, y [kg·m/s]</translation>
    </message>
    <message>
        <source>As components</source>
        <translation>성분으로 입력</translation>
    </message>
</context>
<context>
    <name>thetalane::HitTreeView</name>
    <message>
        <source>%1 hits %2 at %3 s, impulse %4 N·s</source>
        <translation>%3 s에 %1 → %2, 충격량 %4 N·s</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3 s, impulse %4 N·s</source>
        <translation>%3 s에 %1 ↔ %2, 충격량 %4 N·s</translation>
    </message>
    <message>
        <source>Who hit whom</source>
        <translation>누가 누구를 맞혔나</translation>
    </message>
</context>
<context>
    <name>thetalane::ImpulsePage</name>
    <message>
        <source>Impulse of each collision over time</source>
        <translation>시간에 따른 충돌별 충격량</translation>
    </message>
    <message>
        <source>Click a bar to open that collision; press or drag elsewhere to move the time</source>
        <translation>막대를 누르면 그 충돌이 열립니다. 다른 곳을 누르거나 끌면 시각이 바뀝니다</translation>
    </message>
    <message>
        <source>Round: two bodies. Square: a body and a wall. Coloured: the open collision.</source>
        <translation>원: 두 물체의 충돌, 네모: 벽과의 충돌, 색: 열린 충돌</translation>
    </message>
    <message>
        <source>Collision %1: %2, %3 N·s, at %4 s</source>
        <translation>충돌 %1: %2, %3 N·s, %4 s</translation>
    </message>
    <message>
        <source>Impulse of each collision</source>
        <translation>충돌별 충격량</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>시각 [s]</translation>
    </message>
    <message>
        <source>Impulse [N·s]</source>
        <translation>충격량 [N·s]</translation>
    </message>
    <message>
        <source>%1 of %2 are drawn: of those close together the greatest.</source>
        <translation>%2개 가운데 %1개를 그렸습니다. 서로 가까운 것은 가장 큰 것만 그립니다.</translation>
    </message>
    <message>
        <source>Nothing collides in this scene.</source>
        <translation>이 장면에서는 충돌이 일어나지 않습니다.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>First</source>
        <translation>첫째</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>둘째</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>충격량</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
</context>
<context>
    <name>thetalane::InstantNote</name>
    <message numerus="yes">
        <source>Together with, among %n others:</source>
        <translation>
            <numerusform>함께 계산(다른 접촉 %n개 가운데):</numerusform>
        </translation>
    </message>
    <message>
        <source>Together with:</source>
        <translation>함께 계산:</translation>
    </message>
    <message>
        <source>Open collision %1, resolved together with this one</source>
        <translation>함께 계산한 충돌 %1번을 엽니다</translation>
    </message>
    <message>
        <source>Open collision %1: %2</source>
        <translation>충돌 %1번 열기: %2</translation>
    </message>
</context>
<context>
    <name>thetalane::LabPanel</name>
    <message>
        <source>Press a question: it is measured on this machine, and answered with what was found.</source>
        <translation>질문을 누르면 이 컴퓨터에서 바로 재고, 잰 값으로 답합니다.</translation>
    </message>
    <message>
        <source>Speed of the ball</source>
        <translation>공의 속력</translation>
    </message>
    <message>
        <source>How fast the ball comes at the pin</source>
        <translation>공이 핀으로 다가오는 속력</translation>
    </message>
    <message>
        <source>Steps per second, 1/h</source>
        <translation>1초당 계산 횟수 1/h</translation>
    </message>
    <message>
        <source>How often the paper&apos;s loop looks for overlap</source>
        <translation>논문의 반복 계산이 1초에 겹침을 살피는 횟수</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>측정 진행 상황</translation>
    </message>
    <message>
        <source>Diagram</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>What the diagram shows</source>
        <translation>그래프에 나타낼 것</translation>
    </message>
    <message>
        <source>Diagram of the measurement; the table below holds the same numbers</source>
        <translation>측정 결과 그래프. 아래 표에 같은 값이 있습니다</translation>
    </message>
    <message>
        <source>must be greater than 0 and at most 1000</source>
        <translation>0보다 크고 1000 이하여야 합니다</translation>
    </message>
    <message>
        <source>must be from 0.1 to 100000</source>
        <translation>0.1 이상 100000 이하여야 합니다</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>다시 재기</translation>
    </message>
    <message>
        <source>Stops, and keeps what is measured so far</source>
        <translation>멈추고, 그때까지 잰 것은 남깁니다</translation>
    </message>
    <message>
        <source>Measures once more</source>
        <translation>한 번 더 잽니다</translation>
    </message>
    <message>
        <source>Begins …</source>
        <translation>시작하는 중 …</translation>
    </message>
</context>
<context>
    <name>thetalane::LabTable</name>
    <message>
        <source>What each method costs, and how far off it is</source>
        <translation>방법마다 걸리는 시간과 오차</translation>
    </message>
    <message>
        <source>Choose a row to bring its ghost to the front</source>
        <translation>줄을 고르면 그 방법의 그림이 앞으로 나옵니다</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>계산 시간</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>오차</translation>
    </message>
    <message>
        <source>Same pins</source>
        <translation>같은 핀</translation>
    </message>
    <message>
        <source>Differs</source>
        <translation>다른 접촉</translation>
    </message>
    <message>
        <source>The way of computing</source>
        <translation>계산 방법</translation>
    </message>
    <message>
        <source>Processor time of one throw; beside it, to the first row</source>
        <translation>투구 한 번에 드는 계산 시간. 가리키면 첫 줄과의 비가 나옵니다</translation>
    </message>
    <message>
        <source>Position error at the end, median over the throws; on hover the rms and the worst</source>
        <translation>끝난 때의 위치 오차, 투구들의 중앙값. 가리키면 제곱평균제곱근과 최댓값이 나옵니다</translation>
    </message>
    <message>
        <source>The same pins touched; where no pin is, the same bodies</source>
        <translation>같은 핀에 닿은 비율. 핀이 없으면 같은 물체</translation>
    </message>
    <message>
        <source>The first contact that differs, and its time in the reference: median of the throws in which one does</source>
        <translation>처음으로 다른 접촉의 번호와 기준 계산에서의 시각. 다른 접촉이 있는 투구들의 중앙값</translation>
    </message>
    <message>
        <source>too slow</source>
        <translation>너무 느림</translation>
    </message>
    <message>
        <source>%1 to %2 (quartiles of %3 rounds); %4 times the first row</source>
        <translation>%1–%2 (%3회 측정의 사분위수), 첫 줄의 %4배</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>계산 불가</translation>
    </message>
    <message>
        <source>rms %1 m, worst %2 m</source>
        <translation>제곱평균제곱근 %1 m, 최댓값 %2 m</translation>
    </message>
    <message>
        <source>same pins down %1, same contacts %2</source>
        <translation>같은 핀이 쓰러짐 %1, 접촉이 모두 같음 %2</translation>
    </message>
    <message>
        <source>no. %1, %2 s</source>
        <translation>%1번째, %2 s</translation>
    </message>
    <message>
        <source>missed %1, repeated %2 a throw</source>
        <translation>투구 한 번에 놓친 접촉 %1, 되풀이한 접촉 %2</translation>
    </message>
</context>
<context>
    <name>thetalane::LaneScene</name>
    <message>
        <source>Mass %1 kg</source>
        <translation>질량 %1 kg</translation>
    </message>
    <message>
        <source>Speed %1 m/s</source>
        <translation>속력 %1 m/s</translation>
    </message>
    <message>
        <source>Direction %1° from the x axis</source>
        <translation>방향 %1° (x축 기준)</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>정지</translation>
    </message>
    <message>
        <source>Click: open its next collision</source>
        <translation>누르면 이 물체의 다음 충돌을 엽니다</translation>
    </message>
    <message>
        <source>It rolls</source>
        <translation>구르는 중</translation>
    </message>
    <message>
        <source>It slides</source>
        <translation>미끄러지는 중</translation>
    </message>
    <message>
        <source>Turns at %1 rad/s, %2 rpm</source>
        <translation>각속도 %1 rad/s (%2 rpm)</translation>
    </message>
    <message>
        <source>Stays pressed against %1</source>
        <translation>%1에 눌려 맞닿아 있음</translation>
    </message>
</context>
<context>
    <name>thetalane::LaneStrip</name>
    <message>
        <source>The whole lane</source>
        <translation>레인 전체</translation>
    </message>
    <message>
        <source>The whole lane; click where the close-up is to look</source>
        <translation>레인 전체입니다. 누른 곳을 옆 화면에서 크게 보여 줍니다</translation>
    </message>
</context>
<context>
    <name>thetalane::LaneView</name>
    <message>
        <source>Lane</source>
        <translation>레인</translation>
    </message>
    <message>
        <source>Drag to move, turn the wheel to zoom, click a body to open its next collision</source>
        <translation>끌어서 옮기고, 휠로 확대·축소하고, 물체를 누르면 다음 충돌을 엽니다</translation>
    </message>
</context>
<context>
    <name>thetalane::LessonCaption</name>
    <message>
        <source>To the question</source>
        <translation>질문으로</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>마침</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>Leaves the lesson; its scene stays, to go on with</source>
        <translation>수업을 마칩니다. 장면은 그대로 남아 계속 살펴볼 수 있습니다</translation>
    </message>
    <message>
        <source>The next page (Page Down)</source>
        <translation>다음 쪽으로 (Page Down)</translation>
    </message>
    <message>
        <source>To the lesson</source>
        <translation>수업 화면으로</translation>
    </message>
    <message>
        <source>Brings the panel of the lesson to the front</source>
        <translation>수업 패널을 앞으로 가져옵니다</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>The page before (Page Up)</source>
        <translation>앞 쪽으로 (Page Up)</translation>
    </message>
</context>
<context>
    <name>thetalane::LessonPanel</name>
    <message>
        <source>Open a lesson file</source>
        <translation>수업 파일 열기</translation>
    </message>
    <message>
        <source>Lesson files (*.json)</source>
        <translation>수업 파일 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>모든 파일 (*)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>The page before (Page Up)</source>
        <translation>앞 쪽으로 (Page Up)</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>마침</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>Leaves the lesson; its scene stays, to go on with</source>
        <translation>수업을 마칩니다. 장면은 그대로 남아 계속 살펴볼 수 있습니다</translation>
    </message>
    <message>
        <source>The next page (Page Down)</source>
        <translation>다음 쪽으로 (Page Down)</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>수업</translation>
    </message>
    <message>
        <source>Give the lesson: %1</source>
        <translation>수업 시작: %1</translation>
    </message>
    <message>
        <source>Open a lesson file…</source>
        <translation>수업 파일 열기…</translation>
    </message>
    <message>
        <source>A lesson that you wrote in a text editor</source>
        <translation>문서 편집기로 직접 만든 수업을 엽니다</translation>
    </message>
    <message>
        <source>The scene was changed: the words may no longer fit.</source>
        <translation>장면이 바뀌어 설명과 맞지 않을 수 있습니다.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>The scene of this page, as the lesson has it</source>
        <translation>이 쪽의 장면을 수업에 있는 그대로 되돌립니다</translation>
    </message>
    <message>
        <source>Reveal</source>
        <translation>정답 확인</translation>
    </message>
    <message>
        <source>Shows what happens, and why (Page Down)</source>
        <translation>무슨 일이 일어나는지, 왜 그런지 보여 줍니다 (Page Down)</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>수업 목록</translation>
    </message>
</context>
<context>
    <name>thetalane::MainWindow</name>
    <message>
        <source>Open a scene file</source>
        <translation>장면 파일 열기</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>풀이</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>충돌 목록</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>투구</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Reset the scene</source>
        <translation>장면을 처음으로 되돌리기</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>정확도</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>재생 또는 일시 정지</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>The collision before</source>
        <translation>이전 충돌</translation>
    </message>
    <message>
        <source>The next collision</source>
        <translation>다음 충돌</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>이전 단계</translation>
    </message>
    <message>
        <source>The next step of the collision</source>
        <translation>충돌의 다음 단계</translation>
    </message>
    <message>
        <source>Close the collision</source>
        <translation>충돌 닫기</translation>
    </message>
    <message>
        <source>All of the lane in view</source>
        <translation>전체 보기</translation>
    </message>
    <message>
        <source>Fold the panel away, or open it</source>
        <translation>옆 패널 접기/펼치기</translation>
    </message>
    <message>
        <source>Projector mode</source>
        <translation>프로젝터 모드</translation>
    </message>
    <message>
        <source>Dark or light</source>
        <translation>어두운 화면/밝은 화면</translation>
    </message>
    <message>
        <source>한국어 or English</source>
        <translation>한국어/English</translation>
    </message>
    <message>
        <source>The collision, step by step</source>
        <translation>충돌을 단계별로 보기</translation>
    </message>
    <message>
        <source>All collisions</source>
        <translation>모든 충돌</translation>
    </message>
    <message>
        <source>The attributes of the throw</source>
        <translation>투구의 속성</translation>
    </message>
    <message>
        <source>The attributes of the bodies</source>
        <translation>물체의 속성</translation>
    </message>
    <message>
        <source>Speed against accuracy, measured</source>
        <translation>속도와 정확도, 재어 본 값</translation>
    </message>
    <message>
        <source>What this term means; the keys</source>
        <translation>용어의 뜻과 단축키</translation>
    </message>
    <message>
        <source>The first panel; with 2, 3, … the next ones</source>
        <translation>첫 번째 패널, 2, 3, …은 그다음 패널</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>용어</translation>
    </message>
    <message>
        <source>The terms explained, and the keys (F1)</source>
        <translation>용어 풀이와 단축키 (F1)</translation>
    </message>
    <message>
        <source>Play the steps, or hold</source>
        <translation>단계 재생 또는 멈춤</translation>
    </message>
    <message>
        <source>Who hit whom, as a tree</source>
        <translation>어느 물체가 어느 물체를 맞혔는지 나무 그림으로 보기</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>연습</translation>
    </message>
    <message>
        <source>Spares, and what changes if</source>
        <translation>스페어 연습, 조건을 바꾸면 달라지는 것</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>연쇄</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>지도</translation>
    </message>
    <message>
        <source>The strike map: which throws strike</source>
        <translation>스트라이크 지도: 어떤 투구가 스트라이크인지 보기</translation>
    </message>
    <message>
        <source>The foul line, to aim</source>
        <translation>파울 라인 보기(조준)</translation>
    </message>
    <message>
        <source>The pins, close up</source>
        <translation>핀 가까이 보기</translation>
    </message>
    <message>
        <source>The camera follows the ball, or stays</source>
        <translation>카메라가 공을 따라가기/그대로 있기</translation>
    </message>
    <message>
        <source>On a lane: the next thing that the arrow keys aim</source>
        <translation>레인에서: 화살표 키로 조준할 다음 항목</translation>
    </message>
    <message>
        <source>On the bench: the next body that the arrow keys move</source>
        <translation>실험대에서: 화살표 키로 옮길 다음 물체</translation>
    </message>
    <message>
        <source>In a game: throw, or go on</source>
        <translation>게임에서: 던지기 또는 계속하기</translation>
    </message>
    <message>
        <source>A new scene</source>
        <translation>새 장면</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>장면 저장</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>실행 취소</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>다시 실행</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>수업</translation>
    </message>
    <message>
        <source>Lessons: a scene, a few stops, a question</source>
        <translation>수업: 장면과 설명, 그리고 물음</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>예상</translation>
    </message>
    <message>
        <source>Predict what comes, then see it</source>
        <translation>결과를 예상해 보고 확인하기</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>표</translation>
    </message>
    <message>
        <source>Tables, plots, and a worksheet to print</source>
        <translation>표와 그래프, 인쇄할 활동지</translation>
    </message>
    <message>
        <source>Game</source>
        <translation>게임</translation>
    </message>
    <message>
        <source>A game of bowling, for one to eight</source>
        <translation>볼링 게임, 1~8명</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
    <message>
        <source>Strikes, spares and averages</source>
        <translation>스트라이크, 스페어, 평균</translation>
    </message>
</context>
<context>
    <name>thetalane::MapControls</name>
    <message>
        <source>Rack, no friction</source>
        <translation>마찰 없는 핀 배열</translation>
    </message>
    <message>
        <source>Whole lane</source>
        <translation>레인 전체</translation>
    </message>
    <message>
        <source>Usual ball</source>
        <translation>보통 공</translation>
    </message>
    <message>
        <source>Ball of this throw</source>
        <translation>지금 투구의 공</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>장소</translation>
    </message>
    <message>
        <source>The rack alone, the ball close before it; or the whole lane with friction and oil, where direction and axis of rotation are found for each place</source>
        <translation>핀 바로 앞에서 출발하는 핀 배열만, 또는 마찰과 오일이 있는 레인 전체. 레인에서는 칸마다 그렇게 들어오는 방향과 회전축을 찾습니다</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>공</translation>
    </message>
    <message>
        <source>Usual: 6.8 kg; 6.8 m/s at the rack; on the lane 8 m/s and 400 rpm from the middle. Or weight, speed, rotation and position of the present throw</source>
        <translation>보통 공: 6.8 kg, 핀 앞에서 6.8 m/s, 레인에서는 가운데에서 8 m/s와 분당 400회전. 또는 지금 투구의 무게, 속력, 회전, 위치</translation>
    </message>
    <message>
        <source>From left to right</source>
        <translation>가로축</translation>
    </message>
    <message>
        <source>What changes from left to right</source>
        <translation>왼쪽에서 오른쪽으로 달라지는 양</translation>
    </message>
    <message>
        <source>From below to above</source>
        <translation>세로축</translation>
    </message>
    <message>
        <source>What changes from below to above</source>
        <translation>아래에서 위로 달라지는 양</translation>
    </message>
    <message>
        <source>Coefficient of restitution e</source>
        <translation>반발 계수 e</translation>
    </message>
    <message>
        <source>Between ball and pins, and pins and pins</source>
        <translation>공과 핀, 핀과 핀 사이에 적용됩니다</translation>
    </message>
</context>
<context>
    <name>thetalane::MapLegend</name>
    <message>
        <source>Pins down</source>
        <translation>쓰러진 핀</translation>
    </message>
    <message>
        <source>How many pins go down there; amber: all ten, a strike</source>
        <translation>그 자리에서 쓰러지는 핀의 수. 주황색은 열 개 모두, 곧 스트라이크</translation>
    </message>
</context>
<context>
    <name>thetalane::MapPanel</name>
    <message>
        <source>Save the map as a table</source>
        <translation>지도를 표로 저장</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>표 (*.csv)</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>지도를 그림으로 저장</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>그림 (*.png)</translation>
    </message>
    <message>
        <source>Progress of the map</source>
        <translation>지도 계산의 진행</translation>
    </message>
    <message>
        <source>Pins left standing</source>
        <translation>남은 핀</translation>
    </message>
    <message>
        <source>What the throw that is pointed at leaves standing</source>
        <translation>가리킨 투구가 남기는 핀</translation>
    </message>
    <message>
        <source>Table …</source>
        <translation>표 …</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>그림 …</translation>
    </message>
    <message>
        <source>Save the map as a PNG picture, with axes and legend</source>
        <translation>축과 범례를 넣어 PNG 그림으로 저장</translation>
    </message>
    <message>
        <source>Begins …</source>
        <translation>시작 …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>다시 계산</translation>
    </message>
    <message>
        <source>Stops, and keeps what there is</source>
        <translation>멈추고, 지금까지의 결과는 남깁니다</translation>
    </message>
    <message>
        <source>Computes the map once more</source>
        <translation>지도를 다시 계산합니다</translation>
    </message>
    <message>
        <source>A table is made of maps of offset and entry angle</source>
        <translation>표는 벗어난 거리와 입사각의 지도에서만 만듭니다</translation>
    </message>
    <message>
        <source>Save the map as CSV, a line for each place: as thetalane map --csv does</source>
        <translation>칸마다 한 줄씩 CSV로 저장합니다. thetalane map --csv와 같습니다</translation>
    </message>
    <message>
        <source>Point at a place to see what stands there; click to throw it.</source>
        <translation>칸을 가리키면 남는 핀이 보이고, 누르면 그대로 던집니다.</translation>
    </message>
    <message>
        <source>The present throw comes in beside this map.</source>
        <translation>지금 투구는 이 지도를 벗어난 곳으로 들어옵니다.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>저장함: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>쓸 수 없는 파일: %1. %2</translation>
    </message>
</context>
<context>
    <name>thetalane::MapView</name>
    <message>
        <source>Strike map</source>
        <translation>스트라이크 지도</translation>
    </message>
    <message>
        <source>Point at a throw to see what it leaves standing; click to throw it. Arrow keys move, Enter throws.</source>
        <translation>칸을 가리키면 그 투구가 남기는 핀이 보이고, 누르면 던집니다. 화살표 키로 옮기고 Enter로 던집니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>알림 닫기</translation>
    </message>
</context>
<context>
    <name>thetalane::MethodChoice</name>
    <message>
        <source>next event, with a model left out</source>
        <translation>정확한 계산에서 모형 하나를 뺌</translation>
    </message>
    <message>
        <source>Run on the scene in the window</source>
        <translation>창에 있는 장면으로 계산</translation>
    </message>
    <message>
        <source>Runs what is chosen on the scene in the window, against the reference of 113 bits</source>
        <translation>고른 방법으로 창에 있는 장면을 계산해 113비트 기준 계산과 비교합니다</translation>
    </message>
</context>
<context>
    <name>thetalane::MomentumFigure</name>
    <message>
        <source>Momenta tip to tail, before and after</source>
        <translation>충돌 전과 충돌 후의 운동량 벡터의 합</translation>
    </message>
    <message>
        <source>First body solid, second dashed, the total broad; before and after to one scale</source>
        <translation>첫째 물체는 실선, 둘째 물체는 파선, 합은 굵은 화살표입니다. 충돌 전과 후의 축척이 같습니다</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>After</source>
        <translation>충돌 후</translation>
    </message>
</context>
<context>
    <name>thetalane::MomentumPage</name>
    <message>
        <source>Open a collision to see its momenta: Ctrl+→ opens the next one.</source>
        <translation>충돌을 열면 운동량이 보입니다. Ctrl+→로 다음 충돌을 엽니다.</translation>
    </message>
    <message>
        <source>Σp before = %1 kg·m/s</source>
        <translation>충돌 전 Σp = %1 kg·m/s</translation>
    </message>
    <message>
        <source>Σp after = %1 kg·m/s</source>
        <translation>충돌 후 Σp = %1 kg·m/s</translation>
    </message>
    <message>
        <source>The wall takes up the difference.</source>
        <translation>그 차이는 벽이 받습니다.</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>before</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>after</source>
        <translation>충돌 후</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>합계</translation>
    </message>
</context>
<context>
    <name>thetalane::NewGamePage</name>
    <message>
        <source>Go on: %1</source>
        <translation>이어서 하기: %1</translation>
    </message>
    <message>
        <source>Goes on with the latest game that is not over: %1</source>
        <translation>끝나지 않은 가장 최근 게임을 이어서 합니다: %1</translation>
    </message>
    <message>
        <source>New game</source>
        <translation>새 게임</translation>
    </message>
    <message>
        <source>+ Add a player</source>
        <translation>+ 선수 추가</translation>
    </message>
    <message>
        <source>Add a player</source>
        <translation>선수 추가</translation>
    </message>
    <message>
        <source>Up to %1 players take turns</source>
        <translation>최대 %1명이 번갈아 칩니다</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>점수 방식</translation>
    </message>
    <message>
        <source>Lane</source>
        <translation>레인</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>손</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>시드</translation>
    </message>
    <message>
        <source>Traditional: a strike adds the next two balls, a spare the next one. Current frame: a strike is 30, a spare 10 and its first ball.</source>
        <translation>전통 방식: 스트라이크는 다음 두 투구를, 스페어는 다음 한 투구를 더합니다. 커런트 프레임 방식: 스트라이크는 30점, 스페어는 10점에 그 프레임의 첫 투구를 더한 점수입니다.</translation>
    </message>
    <message>
        <source>Oil to 40 ft and dry behind it; dry throughout; or no friction at all</source>
        <translation>40 ft까지 오일이 있고 그 뒤는 드라이 존인 레인, 전체가 마른 레인, 마찰이 전혀 없는 레인</translation>
    </message>
    <message>
        <source>The same number brings the same chance: a game can be thrown again</source>
        <translation>같은 수에서는 같은 우연이 나오므로 게임을 그대로 다시 던질 수 있습니다</translation>
    </message>
    <message>
        <source>Start the game</source>
        <translation>게임 시작</translation>
    </message>
    <message>
        <source>Sets the pins up for the first player</source>
        <translation>첫 선수의 핀을 세웁니다</translation>
    </message>
</context>
<context>
    <name>thetalane::NumberField</name>
    <message>
        <source>must be a number, is empty</source>
        <translation>수를 입력해야 합니다. 지금은 비어 있습니다.</translation>
    </message>
    <message>
        <source>must be a number, is “%1”</source>
        <translation>수를 입력해야 합니다. 지금 값: “%1”</translation>
    </message>
</context>
<context>
    <name>thetalane::PinBadge</name>
    <message>
        <source>Pins touched</source>
        <translation>맞은 핀</translation>
    </message>
    <message>
        <source>down</source>
        <translation>쓰러진 핀</translation>
    </message>
    <message>
        <source>Pins touched: %1, down: %2</source>
        <translation>맞은 핀 %1개, 쓰러진 핀 %2개</translation>
    </message>
</context>
<context>
    <name>thetalane::PinDeck</name>
    <message>
        <source>Standing pins</source>
        <translation>서 있는 핀</translation>
    </message>
    <message>
        <source>no pin stands</source>
        <translation>서 있는 핀 없음</translation>
    </message>
    <message>
        <source>%1; at pin %2</source>
        <translation>%1, 지금 %2번 핀</translation>
    </message>
    <message>
        <source>Click a pin to turn it over; or press its number, 0 for pin 10</source>
        <translation>핀을 누르면 쓰러뜨리거나 세웁니다. 번호 키를 눌러도 되며, 10번 핀은 0입니다</translation>
    </message>
</context>
<context>
    <name>thetalane::PlayPage</name>
    <message>
        <source>Undo</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>Takes the last delivery back; the same player throws again</source>
        <translation>마지막 투구를 되돌립니다. 같은 선수가 다시 던집니다</translation>
    </message>
    <message>
        <source>Foul</source>
        <translation>파울</translation>
    </message>
    <message>
        <source>The last delivery was over the foul line: its pins do not count and are set up again</source>
        <translation>마지막 투구가 파울 라인을 넘었습니다. 쓰러진 핀은 점수에 들지 않고 다시 세웁니다</translation>
    </message>
    <message>
        <source>See again</source>
        <translation>다시 보기</translation>
    </message>
    <message>
        <source>Plays the last delivery again, or the one that is shown</source>
        <translation>마지막 투구나 지금 보이는 투구를 다시 보여 줍니다</translation>
    </message>
    <message>
        <source>Leave the game</source>
        <translation>게임 나가기</translation>
    </message>
    <message>
        <source>The game is saved; it goes on from the list of saved games</source>
        <translation>게임은 저장되어 있으며, 저장한 게임 목록에서 이어서 할 수 있습니다</translation>
    </message>
    <message>
        <source>Deliveries</source>
        <translation>투구 목록</translation>
    </message>
    <message>
        <source>Click a delivery to see it again</source>
        <translation>투구를 누르면 다시 볼 수 있습니다</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>게임 끝</translation>
    </message>
    <message>
        <source>Which pins stand was not entered: the hindmost are set up.</source>
        <translation>어느 핀이 남았는지 입력되지 않아 맨 뒤의 핀부터 세웠습니다.</translation>
    </message>
    <message>
        <source>The window shows something that is not of this game. The game waits.</source>
        <translation>지금 화면에 보이는 것은 이 게임의 장면이 아닙니다. 게임은 잠시 멈춰 있습니다.</translation>
    </message>
    <message>
        <source>Seen again: %1</source>
        <translation>다시 보는 투구: %1</translation>
    </message>
    <message>
        <source>This run is another engine&apos;s; the score is the exact engine&apos;s.</source>
        <translation>지금 보이는 것은 다른 방법으로 계산한 것이고, 점수는 정확한 계산의 결과입니다.</translation>
    </message>
    <message>
        <source>The game could not be saved: %1</source>
        <translation>게임을 저장하지 못했습니다: %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>시드 %1</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>던지기</translation>
    </message>
    <message>
        <source>Throws the ball as it is aimed (Enter)</source>
        <translation>조준한 대로 공을 던집니다 (Enter)</translation>
    </message>
    <message>
        <source>Back to the game</source>
        <translation>게임으로 돌아가기</translation>
    </message>
    <message>
        <source>Sets the turn up again (Enter)</source>
        <translation>차례를 다시 준비합니다 (Enter)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>Tells the score and sets the next turn up (Enter)</source>
        <translation>점수를 적고 다음 차례를 준비합니다 (Enter)</translation>
    </message>
</context>
<context>
    <name>thetalane::PlayerRow</name>
    <message>
        <source>Player %1</source>
        <translation>선수 %1</translation>
    </message>
    <message>
        <source>Name of player %1</source>
        <translation>선수 %1의 이름</translation>
    </message>
    <message>
        <source>The name on the score sheet; left empty, it is &quot;%1&quot;</source>
        <translation>점수판에 적을 이름. 비워 두면 &quot;%1&quot;입니다</translation>
    </message>
    <message>
        <source>Colour of player %1: %2</source>
        <translation>선수 %1의 색: %2</translation>
    </message>
    <message>
        <source>Take player %1 out</source>
        <translation>선수 %1 빼기</translation>
    </message>
</context>
<context>
    <name>thetalane::PracticePanel</name>
    <message>
        <source>Practice</source>
        <translation>연습</translation>
    </message>
</context>
<context>
    <name>thetalane::PredictFigure</name>
    <message>
        <source>Arrows after the collision, as you expect them</source>
        <translation>예측하는 충돌 후의 속도 화살표</translation>
    </message>
    <message>
        <source>Drag the round tips. With the keyboard: arrow keys move the tip, Shift for larger steps, Space changes to the other body.</source>
        <translation>화살표 끝의 동그라미를 끌어 옮깁니다. 키보드에서는 방향 키로 옮기고, Shift를 함께 누르면 크게 움직이며, 스페이스 바로 다른 물체를 고릅니다.</translation>
    </message>
    <message>
        <source>before</source>
        <translation>충돌 전</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>예측</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>실제</translation>
    </message>
</context>
<context>
    <name>thetalane::PredictPanel</name>
    <message>
        <source>What will the collision do? Set the arrows you expect, then reveal.</source>
        <translation>충돌하면 어떻게 될까요? 예상하는 화살표를 그린 뒤 결과를 확인합니다.</translation>
    </message>
    <message>
        <source>No collision is left to predict. Go back in time, or change a velocity or a position.</source>
        <translation>예측할 충돌이 남아 있지 않습니다. 시간을 되돌리거나 속도 또는 위치를 바꾸어 보십시오.</translation>
    </message>
    <message>
        <source>Predict this collision</source>
        <translation>이 충돌 예측하기</translation>
    </message>
    <message>
        <source>Predict the next collision</source>
        <translation>다음 충돌 예측하기</translation>
    </message>
    <message>
        <source>Holds just before the collision and asks what comes of it</source>
        <translation>충돌 직전에 멈추고 결과를 예측합니다</translation>
    </message>
    <message>
        <source>Hold before the collision</source>
        <translation>충돌 직전으로 되돌리기</translation>
    </message>
    <message>
        <source>The lane has gone past it and shows what happens</source>
        <translation>화면이 충돌을 지나 결과가 보이고 있습니다</translation>
    </message>
    <message>
        <source>Predict the collision after it</source>
        <translation>그다음 충돌 예측하기</translation>
    </message>
    <message>
        <source>Holds before the next one</source>
        <translation>다음 충돌 직전에 멈춥니다</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>다시 예측하기</translation>
    </message>
    <message>
        <source>Reveal</source>
        <translation>결과 확인</translation>
    </message>
    <message>
        <source>Hides the truth and takes your arrows up again</source>
        <translation>결과를 숨기고 예측을 고칩니다</translation>
    </message>
    <message>
        <source>Shows what happens beside what you expect</source>
        <translation>실제 결과를 예측과 나란히 보여 줍니다</translation>
    </message>
    <message>
        <source>Collision %1: %2 → %3</source>
        <translation>충돌 %1: %2 → %3</translation>
    </message>
    <message>
        <source>Predict, then reveal</source>
        <translation>예측하고 확인하기</translation>
    </message>
    <message>
        <source>%1 / 100 · %2</source>
        <translation>%1 / 100점 · %2</translation>
    </message>
    <message>
        <source>Energy lost</source>
        <translation>에너지 손실</translation>
    </message>
    <message>
        <source>Expected → truth</source>
        <translation>예측 → 실제</translation>
    </message>
</context>
<context>
    <name>thetalane::PresetRow</name>
    <message>
        <source>The scene in the window</source>
        <translation>창에 있는 장면</translation>
    </message>
    <message>
        <source>Methods of your choice on the scene in the window</source>
        <translation>고른 방법으로 창에 있는 장면을 계산합니다</translation>
    </message>
</context>
<context>
    <name>thetalane::ProgressDots</name>
    <message>
        <source>Page %1 of %2</source>
        <translation>%2쪽 가운데 %1쪽</translation>
    </message>
    <message>
        <source>Page %1 of %2; click a dot to go there</source>
        <translation>%2쪽 가운데 %1쪽. 점을 누르면 그 쪽으로 갑니다</translation>
    </message>
</context>
<context>
    <name>thetalane::QuestionView</name>
    <message>
        <source>Ask again</source>
        <translation>다시 묻기</translation>
    </message>
    <message>
        <source>Hides the answer, for the next who predicts</source>
        <translation>정답을 숨기고 다시 예측하게 합니다</translation>
    </message>
    <message>
        <source>Type what you expect, then reveal.</source>
        <translation>예상하는 값을 입력한 뒤 정답을 확인합니다.</translation>
    </message>
    <message>
        <source>✓ Right: %1</source>
        <translation>✓ 맞았습니다: %1</translation>
    </message>
    <message>
        <source>✗ It is %1, not %2.</source>
        <translation>✗ 예상은 %2, 정답은 %1입니다.</translation>
    </message>
    <message>
        <source>It is %1.</source>
        <translation>정답은 %1입니다.</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>고르기: %1</translation>
    </message>
    <message>
        <source>What you expect; Return reveals the truth</source>
        <translation>예상하는 값. Enter 키를 누르면 정답을 확인합니다</translation>
    </message>
</context>
<context>
    <name>thetalane::RateChooser</name>
    <message>
        <source>Slower</source>
        <translation>느리게</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>빠르게</translation>
    </message>
    <message>
        <source>How fast time goes</source>
        <translation>재생 속도</translation>
    </message>
</context>
<context>
    <name>thetalane::RecoveryBar</name>
    <message>
        <source>Bring back</source>
        <translation>되살리기</translation>
    </message>
    <message>
        <source>Open the scene as it was last edited; it is not saved yet</source>
        <translation>마지막으로 편집한 상태의 장면을 엽니다. 아직 저장되지 않은 상태입니다</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>The edits are deleted</source>
        <translation>편집한 내용을 지웁니다</translation>
    </message>
    <message>
        <source>Not now: ask again at the next start</source>
        <translation>나중에: 다음에 시작할 때 다시 묻습니다</translation>
    </message>
    <message>
        <source>a scene without a name</source>
        <translation>이름 없는 장면</translation>
    </message>
    <message>
        <source>The program ended before “%1” was saved (edited %2).</source>
        <translation>저장하지 않은 채 프로그램이 끝난 장면이 있습니다: “%1” (편집한 때: %2)</translation>
    </message>
    <message>
        <source>There are %1 such scenes.</source>
        <translation>이런 장면이 %1개 있습니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::SavedGamesList</name>
    <message>
        <source>Saved games</source>
        <translation>저장한 게임</translation>
    </message>
    <message>
        <source>Opens the game: one that is not over goes on</source>
        <translation>게임을 엽니다. 끝나지 않은 게임은 이어서 합니다</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: 읽을 수 없음</translation>
    </message>
    <message>
        <source>%1 cannot be read and stays as it is. %2</source>
        <translation>%1 파일을 읽을 수 없으며, 파일은 그대로 둡니다. %2</translation>
    </message>
</context>
<context>
    <name>thetalane::SceneChooser</name>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Two bodies</source>
        <translation>두 물체</translation>
    </message>
    <message>
        <source>Many bodies</source>
        <translation>여러 물체</translation>
    </message>
    <message>
        <source>The lane</source>
        <translation>레인</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>파일 열기…</translation>
    </message>
    <message>
        <source>A scene of one&apos;s own</source>
        <translation>직접 만든 장면</translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation>%1 (수정됨)</translation>
    </message>
    <message>
        <source>Choose a scene: %1</source>
        <translation>장면 고르기: %1</translation>
    </message>
    <message>
        <source>The lesson&apos;s scene</source>
        <translation>수업의 장면</translation>
    </message>
</context>
<context>
    <name>thetalane::ScoreSheet</name>
    <message>
        <source>Score sheet</source>
        <translation>점수판</translation>
    </message>
</context>
<context>
    <name>thetalane::ScoreTable</name>
    <message>
        <source>Score sheet</source>
        <translation>점수판</translation>
    </message>
    <message>
        <source>Player</source>
        <translation>선수</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>합계</translation>
    </message>
    <message>
        <source>max %1</source>
        <comment>the highest possible score</comment>
        <translation>최대 %1</translation>
    </message>
    <message>
        <source>Click a roll to see it again, the total to correct the frame (F2)</source>
        <translation>투구를 누르면 다시 보고, 누계를 누르면 프레임을 고칩니다 (F2)</translation>
    </message>
    <message>
        <source>See ball %1 again</source>
        <translation>%1구 다시 보기</translation>
    </message>
    <message>
        <source>Correct this frame…</source>
        <translation>이 프레임 고치기…</translation>
    </message>
</context>
<context>
    <name>thetalane::ScrubBar</name>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>Drag to any time. Click a tick to open that collision. Arrow keys step by frames, with Ctrl by collisions; Home and End go to the ends.</source>
        <translation>끌어서 원하는 시각으로 옮깁니다. 눈금을 누르면 그 충돌이 열립니다. 화살표 키는 한 프레임씩, Ctrl과 함께 누르면 충돌 단위로 옮기고, Home과 End는 양 끝으로 옮깁니다.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more at the same instant, resolved together</source>
        <translation>
            <numerusform>같은 순간에 %n건 더, 함께 계산</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more at the same instant, in %1 passes</source>
        <translation>
            <numerusform>같은 순간에 %n건 더, 모두 %1회차에 걸쳐 계산</numerusform>
        </translation>
    </message>
    <message>
        <source>Not computed yet; so far %1 s</source>
        <translation>아직 계산되지 않은 구간입니다. 지금까지 %1 s를 계산했습니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::SlowMotionButton</name>
    <message>
        <source>Slow motion at impact</source>
        <translation>충돌 순간 슬로 모션</translation>
    </message>
    <message>
        <source>Slow motion at impact: %1 while the ball meets the pins</source>
        <translation>충돌 순간 슬로 모션: 볼링공이 핀과 부딪치는 동안 %1</translation>
    </message>
</context>
<context>
    <name>thetalane::SpareBox</name>
    <message>
        <source>Spare practice</source>
        <translation>스페어 연습</translation>
    </message>
    <message>
        <source>Click pins to set them up or take them away, or choose a leave; then throw.</source>
        <translation>핀을 눌러 세우거나 치우십시오. 아래에서 남은 핀의 모양을 골라도 됩니다. 그다음 던지십시오.</translation>
    </message>
    <message>
        <source>Throw at these pins</source>
        <translation>이 핀을 향해 던지기</translation>
    </message>
    <message>
        <source>Throws the ball as it is set; it counts as a try</source>
        <translation>지금 정한 대로 던집니다. 시도 한 번으로 셉니다</translation>
    </message>
    <message>
        <source>Show a line that makes it</source>
        <translation>처리하는 경로 보기</translation>
    </message>
    <message>
        <source>Looks for position and direction with this weight, speed and rotation that forgive most</source>
        <translation>이 무게, 속력, 회전으로 가장 여유가 큰 위치와 방향을 찾습니다</translation>
    </message>
    <message>
        <source>made %1 of %2</source>
        <translation>%2번 가운데 %1번 처리</translation>
    </message>
    <message>
        <source>all leaves: %1 of %2</source>
        <translation>전체: %2번 가운데 %1번</translation>
    </message>
    <message>
        <source>On its way …</source>
        <translation>굴러가는 중 …</translation>
    </message>
    <message>
        <source>Missed: %1 left</source>
        <translation>실패: %1 남음</translation>
    </message>
    <message>
        <source>A strike!</source>
        <translation>스트라이크!</translation>
    </message>
    <message>
        <source>Made!</source>
        <translation>처리!</translation>
    </message>
    <message>
        <source>Looking …</source>
        <translation>찾는 중 …</translation>
    </message>
    <message>
        <source>With this ball, no line among those tried makes it.</source>
        <translation>이 공으로 시도해 본 경로 가운데 핀을 모두 처리하는 것이 없습니다.</translation>
    </message>
    <message>
        <source>It is set: the direction may be off by %1° to either side.</source>
        <translation>그 경로로 맞추었습니다. 방향이 양쪽으로 %1°까지 벗어나도 됩니다.</translation>
    </message>
    <message>
        <source>not tried yet</source>
        <translation>아직 던지지 않음</translation>
    </message>
</context>
<context>
    <name>thetalane::StatisticsPanel</name>
    <message>
        <source>This game</source>
        <translation>이번 게임</translation>
    </message>
    <message>
        <source>All saved games</source>
        <translation>저장한 모든 게임</translation>
    </message>
    <message>
        <source>Statistics of</source>
        <translation>통계 범위</translation>
    </message>
    <message>
        <source>Which games are counted</source>
        <translation>통계에 넣을 게임</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
    <message>
        <source>Nothing has been bowled yet.</source>
        <translation>아직 던진 공이 없습니다.</translation>
    </message>
    <message>
        <source>Strikes of the balls at ten pins; spares of the balls at what a first ball left; pocket hits of the first balls that were thrown. The average is of games that are over.</source>
        <translation>스트라이크는 핀 10개에 던진 공 가운데, 스페어는 첫 투구가 남긴 핀에 던진 공 가운데, 포켓은 실제로 던진 첫 투구 가운데 몇 번인지를 나타냅니다. 평균은 끝난 게임의 평균입니다.</translation>
    </message>
    <message>
        <source>Games</source>
        <translation>게임 수</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>평균</translation>
    </message>
    <message>
        <source>Best game</source>
        <translation>최고 점수</translation>
    </message>
    <message>
        <source>Strikes</source>
        <translation>스트라이크</translation>
    </message>
    <message>
        <source>Spares</source>
        <translation>스페어</translation>
    </message>
    <message>
        <source>Open frames</source>
        <translation>오픈 프레임</translation>
    </message>
    <message>
        <source>Splits</source>
        <translation>스플릿</translation>
    </message>
    <message>
        <source>First ball, average</source>
        <translation>첫 투구 평균</translation>
    </message>
    <message>
        <source>Pocket hits</source>
        <translation>포켓 적중</translation>
    </message>
    <message>
        <source>All</source>
        <translation>전체</translation>
    </message>
</context>
<context>
    <name>thetalane::StepFigure</name>
    <message>
        <source>Figure: %1</source>
        <translation>그림: %1</translation>
    </message>
</context>
<context>
    <name>thetalane::StepHeader</name>
    <message>
        <source>Open step %1: %2</source>
        <translation>%1단계 열기: %2</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>%1단계: %2</translation>
    </message>
</context>
<context>
    <name>thetalane::StepOverlay</name>
    <message>
        <source>before %1 m/s</source>
        <translation>충돌 전 %1 m/s</translation>
    </message>
    <message>
        <source>after %1 m/s</source>
        <translation>충돌 후 %1 m/s</translation>
    </message>
</context>
<context>
    <name>thetalane::StepPanel</name>
    <message>
        <source>The steps of the collision</source>
        <translation>충돌의 단계</translation>
    </message>
    <message>
        <source>The collision before (Ctrl+←)</source>
        <translation>이전 충돌 (Ctrl+←)</translation>
    </message>
    <message>
        <source>The collision before</source>
        <translation>이전 충돌</translation>
    </message>
    <message>
        <source>The next collision (Ctrl+→)</source>
        <translation>다음 충돌 (Ctrl+→)</translation>
    </message>
    <message>
        <source>The next collision</source>
        <translation>다음 충돌</translation>
    </message>
    <message>
        <source>Go to the first collision</source>
        <translation>첫 번째 충돌로 가기</translation>
    </message>
    <message>
        <source>Go to the first collision (Ctrl+→)</source>
        <translation>첫 번째 충돌로 가기 (Ctrl+→)</translation>
    </message>
    <message>
        <source>Collision %1 of %2</source>
        <translation>충돌 %1 / %2</translation>
    </message>
    <message>
        <source>Open a collision and see, step by step, how it comes out.</source>
        <translation>충돌을 하나 열어, 그 결과가 나오는 과정을 단계별로 살펴봅시다.</translation>
    </message>
    <message>
        <source>Nothing collides in this run.</source>
        <translation>이 운동에서는 충돌이 일어나지 않습니다.</translation>
    </message>
    <message>
        <source>Or press Ctrl+→, or click a collision on the time line.</source>
        <translation>Ctrl+→ 키나 시간 막대의 눈금으로도 열 수 있습니다.</translation>
    </message>
    <message>
        <source>Change a velocity or a position so that two bodies meet.</source>
        <translation>두 물체가 충돌하도록 속도나 위치를 바꾸어 봅시다.</translation>
    </message>
    <message>
        <source>Collision %1</source>
        <translation>충돌 %1</translation>
    </message>
    <message>
        <source>Digits left: so many decimal digits of this collision&apos;s triangle and velocities are right. Every collision makes the rounding errors before it grow.</source>
        <translation>남은 자릿수: 이 충돌의 삼각형과 속도에서 맞는 십진 자릿수입니다. 충돌할 때마다 그전의 반올림 오차가 커집니다.</translation>
    </message>
    <message>
        <source>digits left: %1</source>
        <translation>남은 자릿수: %1</translation>
    </message>
    <message>
        <source>Hold this step (S)</source>
        <translation>이 단계에서 멈추기 (S)</translation>
    </message>
    <message>
        <source>Play the steps, each held a while (S)</source>
        <translation>단계를 차례로 보여 주기 (S)</translation>
    </message>
</context>
<context>
    <name>thetalane::TablePage</name>
    <message>
        <source>Collisions %1 to %2 of %3</source>
        <translation>충돌 %1–%2 / %3</translation>
    </message>
    <message>
        <source>Collisions %1 to %2</source>
        <translation>충돌 %1–%2</translation>
    </message>
</context>
<context>
    <name>thetalane::TablesPanel</name>
    <message>
        <source>Before and after</source>
        <translation>충돌 전과 충돌 후</translation>
    </message>
    <message>
        <source>All bodies now</source>
        <translation>지금의 모든 물체</translation>
    </message>
    <message>
        <source>Momentum diagram</source>
        <translation>운동량 그림</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>질량 중심</translation>
    </message>
    <message>
        <source>Energy and momentum over time</source>
        <translation>시간에 따른 에너지와 운동량</translation>
    </message>
    <message>
        <source>Impulse of each collision</source>
        <translation>충돌별 충격량</translation>
    </message>
    <message>
        <source>Table or plot</source>
        <translation>표 또는 그래프</translation>
    </message>
    <message>
        <source>Which table or plot is shown</source>
        <translation>어떤 표나 그래프를 볼지 고릅니다</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Copies the numbers shown, with every digit, for a spreadsheet (Ctrl+C)</source>
        <translation>보이는 수를 모든 자릿수로 스프레드시트용으로 복사합니다 (Ctrl+C)</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Writes the numbers shown, with every digit, into a CSV file</source>
        <translation>보이는 수를 모든 자릿수로 CSV 파일에 저장합니다</translation>
    </message>
    <message>
        <source>PNG…</source>
        <translation>PNG…</translation>
    </message>
    <message>
        <source>Writes what is shown as a picture into a PNG file</source>
        <translation>보이는 화면을 PNG 그림 파일로 저장합니다</translation>
    </message>
    <message>
        <source>Worksheet…</source>
        <translation>활동지…</translation>
    </message>
    <message>
        <source>Writes a worksheet of the open collision, or of the first one, with an answer page, as PDF</source>
        <translation>열린 충돌(없으면 첫 번째 충돌)의 활동지를 정답 쪽과 함께 PDF로 저장합니다</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 파일을 저장했습니다.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 파일을 저장할 수 없습니다: %2</translation>
    </message>
    <message>
        <source>Write a CSV file</source>
        <translation>CSV 파일 저장</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 파일 (*.csv)</translation>
    </message>
    <message>
        <source>Write a picture</source>
        <translation>그림 저장</translation>
    </message>
    <message>
        <source>PNG, twice the size on screen (*.png)</source>
        <translation>PNG, 화면 크기의 2배 (*.png)</translation>
    </message>
    <message>
        <source>PNG, %1 pixels wide (*.png)</source>
        <translation>PNG, 가로 %1 픽셀 (*.png)</translation>
    </message>
    <message>
        <source>Write a worksheet</source>
        <translation>활동지 저장</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF 파일 (*.pdf)</translation>
    </message>
</context>
<context>
    <name>thetalane::ThrowPanel</name>
    <message>
        <source>Ball mass</source>
        <translation>볼링공 질량</translation>
    </message>
    <message>
        <source>Mass of the ball: more than 0, at most 7.26 kg</source>
        <translation>볼링공의 질량. 0보다 크고 7.26 kg 이하여야 합니다.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속력</translation>
    </message>
    <message>
        <source>Speed at the foul line: more than 0, at most 100 m/s</source>
        <translation>파울 라인에서의 속력. 0보다 크고 100 m/s 이하여야 합니다.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Angle from straight down the lane, positive to the right</source>
        <translation>레인 방향을 기준으로 잰 각. 오른쪽이 양의 방향입니다.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>The ball&apos;s centre at the foul line, from the middle, positive to the right; boards are counted from the right</source>
        <translation>파울 라인에서 볼링공 중심의 위치. 레인 가운데에서 재며 오른쪽이 양의 방향입니다. 보드는 오른쪽부터 셉니다.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Axis of rotation</source>
        <translation>회전축</translation>
    </message>
    <message>
        <source>Coefficient of restitution e</source>
        <translation>반발 계수 e</translation>
    </message>
    <message>
        <source>Between ball and pins, and pins and pins</source>
        <translation>볼링공과 핀 사이, 핀과 핀 사이에 적용됩니다.</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>던지기</translation>
    </message>
    <message>
        <source>Throw the ball from the foul line</source>
        <translation>파울 라인에서 볼링공을 던집니다.</translation>
    </message>
    <message>
        <source>Default throw</source>
        <translation>기본 투구</translation>
    </message>
    <message>
        <source>Every attribute as it was at first</source>
        <translation>모든 값을 처음대로 되돌립니다.</translation>
    </message>
    <message>
        <source>must be between −90 and 90, is %1</source>
        <translation>−90보다 크고 90보다 작아야 합니다. 지금 값: %1</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>오른쪽으로</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>왼쪽으로</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>똑바로</translation>
    </message>
    <message>
        <source>board %1</source>
        <translation>보드 %1번</translation>
    </message>
    <message>
        <source>Turns a minute at the foul line; it acts through the friction of the lane</source>
        <translation>파울 라인에서의 분당 회전수. 레인의 마찰을 통해서만 경로에 영향을 줍니다.</translation>
    </message>
    <message>
        <source>0: a forward roll; positive: turned so that the ball hooks to the left, 90: side spin alone</source>
        <translation>0°는 앞으로 구르는 회전입니다. 양수이면 공이 왼쪽으로 휘고, 90°는 옆으로만 도는 회전입니다.</translation>
    </message>
    <message>
        <source>forward roll</source>
        <translation>앞으로 구름</translation>
    </message>
    <message>
        <source>hooks left</source>
        <translation>왼쪽 훅</translation>
    </message>
    <message>
        <source>hooks right</source>
        <translation>오른쪽 훅</translation>
    </message>
    <message>
        <source>This lane has no friction, so rotation does not change the path.</source>
        <translation>이 레인에는 마찰이 없으므로 회전이 경로를 바꾸지 않습니다.</translation>
    </message>
    <message>
        <source>Thrown without rotation, the ball slides until friction makes it roll; its path is straight.</source>
        <translation>회전 없이 던진 공은 마찰로 구르게 될 때까지 미끄러지며, 경로는 직선입니다.</translation>
    </message>
    <message>
        <source>The ball slides and curves aside until it rolls; then it goes straight on.</source>
        <translation>공은 미끄러지는 동안 옆으로 휘다가, 구르기 시작하면 똑바로 나아갑니다.</translation>
    </message>
    <message>
        <source>The ball slides and curves aside until it rolls: little on the oil, more beyond it; then it goes straight on.</source>
        <translation>공은 미끄러지는 동안 옆으로 휩니다. 오일 위에서는 조금, 오일이 끝나면 더 많이 휘며, 구르기 시작하면 똑바로 나아갑니다.</translation>
    </message>
    <message>
        <source>Rotation about the axis of a forward roll changes how soon the ball rolls; its path stays straight.</source>
        <translation>앞으로 구르는 방향의 회전은 공이 얼마나 빨리 구르기 시작하는지만 바꾸며, 경로는 직선입니다.</translation>
    </message>
    <message>
        <source>Unit of the mass</source>
        <translation>질량의 단위</translation>
    </message>
    <message>
        <source>Choose the unit</source>
        <translation>단위를 고릅니다.</translation>
    </message>
    <message>
        <source>Unit of the speed</source>
        <translation>속력의 단위</translation>
    </message>
    <message>
        <source>Path shown</source>
        <translation>경로 표시</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>끝까지</translation>
    </message>
    <message>
        <source>to the first contact</source>
        <translation>첫 접촉까지</translation>
    </message>
    <message>
        <source>How much is shown before the ball is thrown</source>
        <translation>볼링공을 던지기 전에 경로를 어디까지 보여 줄지 정합니다.</translation>
    </message>
    <message>
        <source>Rotation and its axis</source>
        <translation>회전과 회전축</translation>
    </message>
    <message>
        <source>Drag the bead: round the ball for the axis, outwards for more rotation. Wheel: rotation, with Shift the axis. Arrow keys; Shift: fine</source>
        <translation>둥근 손잡이를 공 둘레로 끌면 회전축이 바뀌고, 바깥으로 끌수록 회전이 빨라집니다. 휠은 회전, Shift+휠은 회전축을 바꿉니다. 화살표 키로도 조절할 수 있으며 Shift를 누르면 세밀해집니다.</translation>
    </message>
    <message>
        <source>%1 rpm, axis %2°</source>
        <translation>분당 %1회전, 축 %2°</translation>
    </message>
</context>
<context>
    <name>thetalane::TimeReadout</name>
    <message>
        <source>Present time</source>
        <translation>현재 시각</translation>
    </message>
    <message>
        <source>Present time, in seconds of the run</source>
        <translation>현재 시각(초)</translation>
    </message>
</context>
<context>
    <name>thetalane::TimelineBar</name>
    <message>
        <source>To the start</source>
        <translation>처음으로</translation>
    </message>
    <message>
        <source>To the start (R)</source>
        <translation>처음으로 (R)</translation>
    </message>
    <message>
        <source>Collision before</source>
        <translation>이전 충돌</translation>
    </message>
    <message>
        <source>Collision before (Ctrl+←)</source>
        <translation>이전 충돌 (Ctrl+←)</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>한 프레임 뒤로</translation>
    </message>
    <message>
        <source>One frame back (←)</source>
        <translation>한 프레임 뒤로 (←)</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>한 프레임 앞으로</translation>
    </message>
    <message>
        <source>One frame forward (→)</source>
        <translation>한 프레임 앞으로 (→)</translation>
    </message>
    <message>
        <source>Next collision</source>
        <translation>다음 충돌</translation>
    </message>
    <message>
        <source>Next collision (Ctrl+→)</source>
        <translation>다음 충돌 (Ctrl+→)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>재생</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>일시 정지 (스페이스 바)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>재생 (스페이스 바)</translation>
    </message>
</context>
<context>
    <name>thetalane::TopBar</name>
    <message>
        <source>Reset the scene</source>
        <translation>처음으로 되돌리기</translation>
    </message>
    <message>
        <source>Reset the scene (R)</source>
        <translation>처음으로 되돌리기 (R)</translation>
    </message>
    <message>
        <source>Projector</source>
        <translation>프로젝터</translation>
    </message>
    <message>
        <source>Large type and lines for a projector (F11)</source>
        <translation>프로젝터에 맞춘 큰 글씨와 굵은 선 (F11)</translation>
    </message>
    <message>
        <source>Language of everything (L)</source>
        <translation>화면의 언어 (L)</translation>
    </message>
    <message>
        <source>Dark or light, and how much moves</source>
        <translation>어두운 화면/밝은 화면, 움직임 줄이기</translation>
    </message>
    <message>
        <source>Dark (D)</source>
        <translation>어두운 화면 (D)</translation>
    </message>
    <message>
        <source>Less motion: nothing flies or turns by itself</source>
        <translation>움직임 줄이기: 화면이 저절로 움직이거나 돌지 않습니다</translation>
    </message>
</context>
<context>
    <name>thetalane::UntilChooser</name>
    <message>
        <source>End of the run</source>
        <translation>계산을 마치는 시각</translation>
    </message>
    <message>
        <source>The run goes on until %1; choose a longer or a shorter one</source>
        <translation>%1까지의 운동을 계산합니다. 더 길거나 짧은 시간을 고를 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::VaryBox</name>
    <message>
        <source>The range must begin below its end.</source>
        <translation>범위의 처음은 끝보다 작아야 합니다.</translation>
    </message>
    <message>
        <source>%1 of %2 throws strike.</source>
        <translation>투구 %2번 가운데 %1번이 스트라이크입니다.</translation>
    </message>
    <message>
        <source>%1 of %2 throws clear the pins.</source>
        <translation>투구 %2번 가운데 %1번이 핀을 모두 쓰러뜨립니다.</translation>
    </message>
    <message>
        <source>What changes if …</source>
        <translation>무엇이 달라질까</translation>
    </message>
    <message>
        <source>The same throw with one attribute varied. The present value is marked; click a row to make it the throw.</source>
        <translation>같은 투구에서 한 가지만 바꾸어 봅니다. 지금 값에는 표시가 있고, 줄을 누르면 그 투구로 바뀝니다.</translation>
    </message>
    <message>
        <source>Attribute to vary</source>
        <translation>바꿀 속성</translation>
    </message>
    <message>
        <source>Which attribute of the throw changes from row to row</source>
        <translation>줄마다 달라지는 투구의 속성</translation>
    </message>
    <message>
        <source>from</source>
        <translation>처음</translation>
    </message>
    <message>
        <source>to</source>
        <translation>끝</translation>
    </message>
    <message>
        <source>From</source>
        <translation>처음</translation>
    </message>
    <message>
        <source>The first value</source>
        <translation>첫째 값</translation>
    </message>
    <message>
        <source>To</source>
        <translation>끝</translation>
    </message>
    <message>
        <source>The last value</source>
        <translation>마지막 값</translation>
    </message>
    <message>
        <source>Outcomes</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Click a row, or press Enter on it, to make it the throw</source>
        <translation>줄을 누르거나 Enter를 누르면 그 투구로 바뀝니다</translation>
    </message>
</context>
<context>
    <name>thetalane::VaryModel</name>
    <message>
        <source>cannot be thrown</source>
        <translation>던질 수 없음</translation>
    </message>
    <message>
        <source>a strike</source>
        <translation>스트라이크</translation>
    </message>
    <message>
        <source>all of them down</source>
        <translation>모두 쓰러짐</translation>
    </message>
    <message>
        <source>%1 down, left standing %2</source>
        <translation>%1개 쓰러짐, 남은 핀 %2</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>남은 핀</translation>
    </message>
    <message>
        <source>Pins left standing</source>
        <translation>남은 핀</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>쓰러짐</translation>
    </message>
    <message>
        <source>Pins that went down</source>
        <translation>쓰러진 핀의 수</translation>
    </message>
    <message>
        <source>First
pin</source>
        <translation>처음
닿은 핀</translation>
    </message>
    <message>
        <source>The pin that the ball touches first</source>
        <translation>공이 처음 닿는 핀</translation>
    </message>
    <message>
        <source>Offset
[cm]</source>
        <translation>거리
[cm]</translation>
    </message>
    <message>
        <source>Where the ball&apos;s path passes the head pin [cm], positive to the right</source>
        <translation>공의 경로가 헤드핀의 중심에서 벗어난 거리 [cm]. 오른쪽이 양의 방향입니다</translation>
    </message>
    <message>
        <source>Angle
[°]</source>
        <translation>입사각
[°]</translation>
    </message>
    <message>
        <source>The entry angle [°], positive to the left</source>
        <translation>입사각 [°]. 왼쪽이 양의 방향입니다</translation>
    </message>
</context>
<context>
    <name>thetalane::WallGroup</name>
    <message>
        <source>Walls</source>
        <translation>벽</translation>
    </message>
    <message>
        <source>Left, x</source>
        <translation>왼쪽, x</translation>
    </message>
    <message>
        <source>Right, x</source>
        <translation>오른쪽, x</translation>
    </message>
    <message>
        <source>Bottom, y</source>
        <translation>아래쪽, y</translation>
    </message>
    <message>
        <source>Top, y</source>
        <translation>위쪽, y</translation>
    </message>
    <message>
        <source>Whether there is a wall here; without one this side is open</source>
        <translation>이쪽에 벽을 둘지 정합니다. 벽이 없으면 열려 있습니다</translation>
    </message>
    <message>
        <source>Where the wall stands</source>
        <translation>벽의 위치</translation>
    </message>
    <message>
        <source>Coefficient of restitution e of the walls</source>
        <translation>벽의 반발 계수 e</translation>
    </message>
    <message>
        <source>0: perfectly inelastic, 1: elastic. Between bodies and walls.</source>
        <translation>0: 완전 비탄성, 1: 탄성. 물체와 벽 사이에 적용됩니다.</translation>
    </message>
</context>
<context>
    <name>thetalane::WordsPanel</name>
    <message>
        <source>Search the terms</source>
        <translation>용어 찾기</translation>
    </message>
    <message>
        <source>Shows the terms that contain these letters</source>
        <translation>이 글자가 든 용어만 보여 줍니다</translation>
    </message>
    <message>
        <source>Terms and keys</source>
        <translation>용어와 단축키</translation>
    </message>
    <message>
        <source>No term contains these letters.</source>
        <translation>이 글자가 든 용어가 없습니다.</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>용어</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
</context>
<context>
    <name>thetalane::ZoomButtons</name>
    <message>
        <source>Zoom in</source>
        <translation>확대</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>축소</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>전체 보기</translation>
    </message>
    <message>
        <source>Show the rack</source>
        <translation>핀 보기</translation>
    </message>
    <message>
        <source>Show the foul line</source>
        <translation>파울 라인 보기</translation>
    </message>
    <message>
        <source>Follow the ball</source>
        <translation>공 따라가기</translation>
    </message>
</context>
</TS>
