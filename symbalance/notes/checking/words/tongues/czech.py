"""Czech terms of engines, shafts and vibrations."""

OF = ""
TERMS = r"""
mean piston speed: středn\w+ (?:pístov\w+ )?rychlost\w*(?: pístu)?
largest piston speed: (?:maximáln|největš)\w+ (?:rychlost\w* pístu|pístov\w+ rychlost\w*)
piston velocity: rychlost\w* pístu|pístov\w+ rychlost\w*
largest piston acceleration: (?:maximáln|největš)\w+ zrychlen\w+ pístu
piston acceleration: zrychlen\w+ pístu
piston displacement: (?:výchylk\w+|dráh\w+|zdvih\w*|posun\w+|posuv\w*) pístu
piston area: ploch\w+ pístu
swept volume: zdvihov\w+ objem\w*
compression ratio: kompresn\w+ poměr\w*
clearance volume: kompresn\w+ (?:objem|prostor)\w*
gas force: síl\w+ (?:od )?(?:tlaku )?plynů|sil\w+ plynů|plynov\w+ síl\w+
side thrust: bočn\w+ síl\w+|normálov\w+ síl\w+ (?:na stěnu|pístu)\w*|bočn\w+ tlak\w*
connecting rod force: síl\w+ (?:v ojnici|ojnice|na ojnici)|ojničn\w+ síl\w+
tangential force: (?:tečn|tangenciáln)\w+ síl\w+
radial force: radiáln\w+ síl\w+
piston force: síl\w+ na píst\w*|pístov\w+ síl\w+
mean torque: středn\w+ (?:točiv\w+|krout\w+) moment\w*
inertia torque: moment\w* (?:od )?setrvačných sil
engine torque: (?:točiv\w+ |krout\w+ )moment\w* motoru
equivalent bending moment: (?:redukovan|ekvivalentn)\w+ ohybov\w+ moment\w*
equivalent twisting moment: (?:redukovan|ekvivalentn)\w+ krout\w+ moment\w*
bending moment: ohybov\w+ moment\w*
polar second moment of area: polárn\w+ (?:kvadratick\w+ )?moment\w*(?: setrvačnosti)?(?: průřezu)?
second moment of area: (?:osov\w+ )?kvadratick\w+ moment\w*(?: průřezu)?
polar section modulus: (?:průřezov\w+ modul\w* )?v krutu průřezov\w+ modul\w*
polar section modulus: modul\w* (?:průřezu )?v krutu|průřezov\w+ modul\w* v krutu
section modulus in bending: modul\w* (?:průřezu )?v ohybu|průřezov\w+ modul\w* v ohybu
section modulus: průřezov\w+ modul\w*
moment of inertia: moment\w* setrvačnosti
torque: točiv\w+ moment\w*|krout\w+ moment\w*
inertia force: setrvačn\w+ s[ií]l\w*
first order: (?:prvního|1\.|I\.) řádu
second order: (?:druhého|2\.|II\.) řádu
fourth order: (?:čtvrtého|4\.|IV\.) řádu
centrifugal force: odstřediv\w+ s[ií]l\w*
reciprocating mass: (?:posuvn\w+|vratn\w+) (?:se pohybující )?hmot\w+
reciprocating mass: hmotnost\w* posuvn\w+ (?:hmot|část\w+)
rotating mass: rotujíc\w+ hmot\w+|hmotnost\w* rotujíc\w+ (?:hmot|část\w+)
rod mass: hmotnost\w* ojnice
piston mass: hmotnost\w* pístu
degree of irregularity: (?:stup\w+|součinitel\w*) nerovnoměrnosti(?: chodu)?
fluctuation of energy: přebyt\w+ práce|kolísán\w+ energie
kinetic energy: kinetick\w+ energi\w+|pohybov\w+ energi\w+
flywheel: setrvačník\w*
shear modulus: modul\w* (?:pružnosti )?(?:ve smyku|pružnosti ve smyku)
bending stress: ohybov\w+ napět\w+|napět\w+ v ohybu
torsional stress: napět\w+ v krutu|(?:smykov\w+ )?napět\w+ (?:od krutu|v krutu)
equivalent stress: (?:redukovan|ekvivalentn)\w+ napět\w+
torsional stiffness: torzn\w+ tuhost\w*|tuhost\w* v krutu
angle of twist: úh\w+ zkroucení|úh\w+ zkrutu
damped natural angular frequency: (?:vlastn\w+ )?úhlov\w+ frekvenc\w+ tlumen\w+ kmit\w*
natural angular frequency: vlastn\w+ (?:úhlov|kruhov)\w+ frekvenc\w+
natural frequency: vlastn\w+ frekvenc\w+
amplitude ratio: poměr\w* (?:amplitud|výchylek)
position of the node: poloh\w+ uzlu|vzdálenost\w* uzlu
node: uz(?:el|lu|lem)
critical speed: kritick\w+ otáč\w+|kritick\w+ rychlost\w*
magnification factor: součinitel\w* (?:zesílení|naladění)|činitel\w* zesílení
damping ratio: poměrn\w+ (?:útlum\w*|tlumen\w+)
logarithmic decrement: logaritmick\w+ dekrement\w*(?: útlumu)?
critical damping: kritick\w+ (?:útlum\w*|tlumen\w+)
undamped: netlumen\w+
damped: tlumen(?:ých|é|ého|ém|á|ou|ý|ým)
damping: tlumení|útlum\w*
period: period[ayuě]|perioda
firing interval: (?:rozestup\w*|interval\w*|odstup\w*) (?:zážehů|zapalování)
counterweight: protizávaž\w+|vývaž\w+
balance shaft: vyvažovac\w+ hřídel(?:e|i)?
crank radius: poloměr\w* (?:kliky|zalomení)
connecting rod length: délk\w+ ojnice
crank angle: úh\w+ (?:natočení |pootočení )?(?:kliky|klikového hřídele|klikové hřídele)
rod angle: úh\w+ (?:odklonu |vychýlení |výkyvu )?ojnice|odklon\w* ojnice
angular velocity of the rod: úhlov\w+ rychlost\w* ojnice
angular acceleration of the rod: úhlov\w+ zrychlen\w+ ojnice
angular velocity: úhlov\w+ rychlost\w*
angular acceleration: úhlov\w+ zrychlen\w+
rotational speed: otáčk\w+|otáček|frekvenc\w+ otáčení
circumferential speed: obvodov\w+ rychlost\w*
mean effective pressure: středn\w+ efektivn\w+ tlak\w*
indicated mean effective pressure: středn\w+ indikovan\w+ tlak\w*
mechanical efficiency: mechanick\w+ účinnost\w*
efficiency: účinnost\w*
brake power: efektivn\w+ výkon\w*
indicated power: indikovan\w+ výkon\w*
power: výkon\w*
four-stroke: čtyřdob\w+
two-stroke: dvoudob\w+
stroke: zdvih\w*
bore: vrtán\w+
top dead centre: horn\w+ úvra\w+|HÚ
bottom dead centre: doln\w+ úvra\w+|DÚ
radius of gyration: poloměr\w* setrvačnosti
radius: poloměr\w*
diameter: průměr(?:u|em)?
density: hustot\w+
mass: hmotnost\w*
length: délk\w+
thickness: tloušťk\w+
force: síl[aouy]+
forces: sil
pressure: tlak(?:u|em)?
area: ploch[aouy]+|obsah\w*
stiffness: tuhost\w*
speed: rychlost\w*
acceleration: zrychlen\w+
frequency: frekvenc\w+
energy: energi\w+
work of one cycle: prác\w* (?:jednoho )?cyklu
work: práce|práci
two discs: dv(?:a|ou|ěma|ě) (?:kotouč|disk|hmot|setrvačník)\w*
thin ring: tenk\w+ prste\w+
solid disc: pln\w+ (?:kotouč|disk)\w*
disc: kotouč\w*|disk\w*
rim: vě?nec|věnce
shaft: hřídel(?:e|i|em)?
hollow: dut\w+|trubkov\w+
fixed: vetknut\w+
offset: vyosen\w+|přesazen\w+|excentrick\w+
piston: píst(?:u|em)?
crankshaft: klikov\w+ hřídel\w*
crank: klik(?:[ayuě]|ou)
connecting rod: ojnic\w+
engine: motor(?:u|em)?
cylinder: vál(?:ec|ce|ci)
cylinders: válců|válcích
single-cylinder: jednoválc\w+
four-cylinder: čtyřválc\w+
both: ob(?:a|ě|ou)
each: každ\w+
half: polovin\w+|poloviční\w*|půl
total: celkov\w+
sum: součet|součtu
resultant: výsledn\w+
relative: relativn\w+
difference: rozdíl\w*
component: složk\w+
ratio: poměr\w*
parallel: paraleln\w+|rovnoběžn\w+
series: sériov\w+|sérii
largest: maximáln\w+|největš\w+
smallest: minimáln\w+|nejmenš\w+
mean: středn\w+|průměrn\w+
approximately: přibližně
wrong: chybn\w+
not: není
from the: od
is: je|činí|rovná se
are: jsou
and: a zároveň
where: kde
at the top dead centre: v (?:horní úvrati|HÚ)
at the bottom dead centre: v (?:dolní úvrati|DÚ)
on: na
between: mezi
for: pro|při
two: dv(?:a|ě|ou)
three: tři|tří
four: čtyři|čtyř
six: šest|šesti
centre of gravity: těžišt\w+
pair: pár(?:y|u)?
proportional: úměrn\w+
unit: jednot\w+
specific: měrn\w+
divided: dělen\w+
squared: na druhou|kvadrát\w*
square section: čtvercov\w+
rectangular: obdélníkov\w+
annular: prstencov\w+|mezikruh\w*|mezikruž\w*
solid: pln(?:ý|á|é|ého)
amplitude: amplitud\w+
harmonic: harmonick\w+
coefficient: koeficient\w*|součinitel\w*
distance: vzdálenost\w*|rozteč\w*
height: výšk\w+
width: šířk\w+
gear: ozuben\w+|převod\w*
pendulum: kyvadl\w+
spring: pružin\w+
friction: třen\w+
belt: řemen\w*
notch: vrub\w*
thin-walled: tenkostěnn\w+
rotating: rotujíc\w+
dead centres: úvrat(?:ě|ích)
if: pokud|jestliže
when: když
another: jin(?:ý|á|é|ého)
case: případ\w*
whereas: zatímco
static deflection: statick\w+ průhyb\w*
deflection: průhyb\w*
in the middle: uprostřed|v polovině
bearings: ložisk\w+|ložisek
mass per length: hmotnost\w* na jednotku délky
three discs: tři kotouče|tří kotoučů
absorber: dynamick\w+ hltič\w*|hltič\w* kmitů
mass ratio: poměr\w* hmotností
frequency ratio: poměr\w* frekvencí
simple harmonic motion: harmonick\w+ (?:pohyb|kmit)\w*
"""
