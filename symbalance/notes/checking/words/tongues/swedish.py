"""Swedish terms of engines, shafts and vibrations."""

OF = ""
TERMS = r"""
mean piston speed: medelkolvhastighet\w*|kolvmedelhastighet\w*|kolvens medelhastighet
largest piston speed: (?:största|maximala|högsta) kolvhastighet\w*
largest piston speed: kolvens (?:största|maximala|högsta) hastighet
piston velocity: kolvhastighet\w*|kolvens hastighet
largest piston acceleration: (?:största|maximala) kolvacceleration\w*
largest piston acceleration: kolvens (?:största|maximala) acceleration
piston acceleration: kolvacceleration\w*|kolvens acceleration
piston displacement: kolvförskjutning\w*|kolvens (?:förskjutning|läge)|kolvväg\w*
piston area: kolvare[ao]\w*|kolvyta\w*|kolvens (?:area|yta)
swept volume: slagvolym\w*|cylindervolym\w*
compression ratio: kompressionsförhållande\w*
clearance volume: kompressionsvolym\w*
gas force: gaskraft\w*
side thrust: sidokraft\w*|normalkraft\w* (?:mot|på) cylinder\w*|sidotryck\w*|kolvens sidokraft
connecting rod force: vevstaks?kraft\w*|vevstakens kraft|kraften i vevstaken
tangential force: tangential ?kraft\w*|tangentiell\w* kraft\w*
radial force: radial ?kraft\w*|radiell\w* kraft\w*
piston force: kolvkraft\w*
mean torque: medelmoment\w*|medelvridmoment\w*
inertia torque: massmoment\w*|vridmoment\w* av masskraft\w*
engine torque: motormoment\w*|motorns (?:vrid)?moment
equivalent bending moment: ekvivalent\w* böjmoment\w*
equivalent twisting moment: ekvivalent\w* vridmoment\w*
bending moment: böj(?:ande )?moment\w*
torque: vridmoment\w*|vridande moment\w*
inertia force: masskraft\w*|masskrafter\w*|tröghetskraft\w*|tröghetskrafter\w*
first order: första ordning\w*|ordning 1|1:a ordning\w*
second order: andra ordning\w*|ordning 2|2:a ordning\w*
fourth order: fjärde ordning\w*|ordning 4|4:e ordning\w*
centrifugal force: centrifugalkraft\w*|centrifugalkrafter\w*
reciprocating mass: (?:fram- ?och ?återgående|oscillerande) mass(?:a|an|or|orna)
rotating mass: roterande mass(?:a|an|or|orna)
rod mass: vevstaks?massa\w*|vevstakens massa
piston mass: kolvmassa\w*|kolvens massa
degree of irregularity: ojämnhetsgrad\w*|olikformighetsgrad\w*
fluctuation of energy: arbetsöverskott\w*|energivariation\w*
kinetic energy: kinetisk\w* energi\w*|rörelseenergi\w*
flywheel: svänghjul\w*
polar second moment of area: polär\w* (?:yt)?tröghetsmoment\w*|polär\w* yttröghetsmoment\w*
second moment of area: yttröghetsmoment\w*
moment of inertia: (?:mass)?tröghetsmoment\w*|tröghetsmoment\w*
polar section modulus: vridmotstånd\w*
section modulus in bending: böjmotstånd\w*
section modulus: böjmotstånd\w*|motståndsmoment\w*
shear modulus: skjuvmodul\w*
bending stress: böjspänning\w*
torsional stress: vridspänning\w*|vridskjuvspänning\w*
equivalent stress: (?:effektiv|jämförelse|ekvivalent)\w*spänning\w*|ekvivalent\w* spänning\w*
torsional stiffness: vridstyvhet\w*|torsionsstyvhet\w*|vridfjäderkonstant\w*
angle of twist: vridningsvinkel\w*|förvridningsvinkel\w*
natural angular frequency: egenvinkelfrekvens\w*
damped natural angular frequency: dämpad\w* egenvinkelfrekvens\w*
natural frequency: egenfrekvens\w*
amplitude ratio: amplitudförhållande\w*
position of the node: nodens läge
node: nod(?:en)?
critical speed: kritisk\w* varvtal\w*
magnification factor: förstoringsfaktor\w*|förstärkningsfaktor\w*
damping ratio: dämpningsgrad\w*|relativ\w* dämpning\w*|dämpningsförhållande\w*
logarithmic decrement: logaritmisk\w* dekrement\w*
critical damping: kritisk\w* dämpning\w*
undamped: odämpa\w*
damped: dämpa(?:d|de|t)
damping: dämpning\w*
period: svängningstid\w*|period\w*
firing interval: tändningsintervall\w*|tändintervall\w*|tändavstånd\w*
firing frequency: tändningsfrekvens\w*|tändfrekvens\w*
counterweight: motvikt\w*
balance shaft: balansaxel\w*
balance shafts: balansaxlar\w*
crank radius: vevradie\w*|vevens radie
connecting rod length: vevstaks?längd\w*|vevstakens längd
crank angle: vevvinkel\w*|vevaxelvinkel\w*
rod angle: vevstaks?vinkel\w*|vevstakens (?:vinkel|lutning)
angular velocity of the rod: vevstakens vinkelhastighet
angular acceleration of the rod: vevstakens vinkelacceleration
angular velocity: vinkelhastighet\w*
angular acceleration: vinkelacceleration\w*
rotational speed: varvtal\w*
circumferential speed: periferihastighet\w*
mean effective pressure: (?:effektivt )?medeleffektivt tryck|effektiv\w* medeltryck\w*
indicated mean effective pressure: indikera\w* medeltryck\w*
mechanical efficiency: mekanisk\w* verkningsgrad\w*
efficiency: verkningsgrad\w*
brake power: effektiv\w* effekt\w*
indicated power: indikera\w* effekt\w*
power: effekt(?:en)?
four-stroke: fyrtakt\w*
two-stroke: tvåtakt\w*
stroke: slaglängd\w*
bore: cylinderdiameter\w*
top dead centre: övre dödpunkt\w*|övre vändläge\w*|ÖDP
bottom dead centre: (?:undre|nedre) dödpunkt\w*|(?:undre|nedre) vändläge\w*|UDP|NDP
radius of gyration: tröghetsradie\w*
radius: radien?
diameter: diameter\w*
density: densitet\w*
mass: massan?
length: längd(?:en)?
thickness: tjocklek\w*
force: kraft(?:en)?
forces: krafter(?:na)?
pressure: trycket|tryck
area: area|arean|ytan?
stiffness: styvhet\w*
speed: hastighet\w*
frequency: frekvens\w*
energy: energi\w*
work of one cycle: arbet\w+ (?:per|under en) cykel
work: arbete?t?
two discs: två (?:skivor|svänghjul|massor)(?:na)?
thin ring: tunn ring
solid disc: homogen skiva
disc: skivan?
rim: ringen|kransen
shaft: axeln?
hollow: ihålig\w*|rör(?:et|formig\w*)?
fixed: fast inspänd\w*|inspänd\w*
offset: desaxer\w*|excentrisk\w*
piston: kolv(?:en)?
crankshaft: vevaxel\w*
crank: vev(?:en)?
connecting rod: vevstak(?:e|en)
engine: motorn?
cylinder: cylindern?
cylinders: cylindrar(?:na)?
single-cylinder: encylindrig\w*
four-cylinder: fyrcylindrig\w*
both: båda
each: varje|vardera
half: hälften|halva?
total: totala?|sammanlagda?
sum: summan?
resultant: resulterande|resultanten?
relative: relativa?
difference: skillnad\w*
component: komponent\w*
ratio: förhållande\w*
parallel: parallella?
series: serie
largest: största|maximala?|högsta
smallest: minsta|minimala?
mean: medel\w*
approximately: approximativt|ungefär
wrong: felaktig\w*|fel
not: inte|ej
from the: från
is: är|blir
the: den|det
a: en|ett
of: av
and: och
with: med
where: där
between: mellan
for: för
on: på
at: vid
at the top dead centre: i (?:övre dödpunkten|ÖDP)
at the bottom dead centre: i (?:undre|nedre) dödpunkten
two: två
three: tre
four: fyra
six: sex
centre of gravity: tyngdpunkt\w*|masscentrum
pair: par
proportional: proportionell\w*
unit: enhet\w*
specific: specifik\w*
divided: delad|dividera\w*
squared: kvadraten? på|i kvadrat
square section: kvadratisk\w*
rectangular: rektangulär\w*
annular: ringformig\w*
solid: massiv\w*
amplitude: amplitud\w*
harmonic: harmonisk\w*|deltonen?
coefficient: koefficient\w*
distance: avstånd\w*
height: höjd\w*
width: bredd\w*
gear: kugghjul\w*|växel\w*
pendulum: pendel\w*
spring: fjäder\w*
springs: fjädrar\w*
friction: friktion\w*
belt: rem(?:men)?
notch: anvisning\w*
thin-walled: tunnväggig\w*
rotating: roterande
dead centres: dödpunkterna|vändlägena
if: om
when: när
another: en annan|ett annat
case: fall(?:et)?
whereas: medan
static deflection: statisk\w* (?:nedböjning|utböjning|nedsjunkning)
deflection: nedböjning\w*|utböjning\w*
in the middle: på mitten|i mitten
bearings: lager(?:na)?
mass per length: massa per (?:längdenhet|meter)
angular frequency: vinkelfrekvens\w*
three discs: tre (?:skivor|massor|svänghjul)
absorber: svängningsdämpare|dynamisk dämpare
mass ratio: massförhållande\w*
frequency ratio: frekvensförhållande\w*
simple harmonic motion: harmonisk (?:rörelse|svängning)
"""
