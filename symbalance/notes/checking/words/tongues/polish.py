"""Polish terms of engines, shafts and vibrations."""

OF = ""
TERMS = r"""
mean piston speed: średni\w* prędkoś\w* tłoka
largest piston speed: (?:maksymaln|największ)\w* prędkoś\w* tłoka
piston velocity: prędkoś\w* tłoka
largest piston acceleration: (?:maksymaln|największ)\w* przyspieszeni\w* tłoka
piston acceleration: przyspieszeni\w* tłoka
piston displacement: (?:przemieszczeni|przesunięci)\w* tłoka|drog\w+ tłoka
piston area: (?:powierzchni\w*|pol\w) (?:przekroju )?tłoka|pole (?:powierzchni )?tłoka
swept volume: objętoś\w* skokow\w*|pojemnoś\w* skokow\w*
compression ratio: stop(?:ień|ni\w*) sprężania
clearance volume: objętoś\w* komory spalania|objętoś\w* szkodliw\w*
gas force: sił\w (?:ciśnienia )?gaz(?:ów|owa|owej|u)
side thrust on the cylinder wall: nacisk\w* (?:boczn\w* )?(?:tłoka )?na (?:gładź|ściankę)(?: cylindra)?
side thrust: sił\w (?:boczn\w+|normaln\w+)|nacisk boczny
connecting rod force: sił\w (?:w korbowodzie|wzdłuż korbowodu|w osi korbowodu)
tangential force: sił\w styczn\w+
radial force: sił\w (?:promieniow|radialn)\w+
piston force: sił\w (?:tłokow\w+|na tłok\w*)
mean torque: średni\w* moment\w* obrotow\w*
inertia torque: moment\w* (?:obrotow\w* )?(?:od )?sił bezwładności
engine torque: moment\w* (?:obrotow\w* )?silnika
equivalent bending moment: (?:zastępcz|zredukowan)\w* moment\w* (?:gnąc|zginając)\w*
equivalent bending moment: moment\w* (?:gnąc|zginając)\w* (?:zastępcz|zredukowan)\w*
equivalent twisting moment: (?:zastępcz|zredukowan)\w* moment\w* skręcając\w*
equivalent twisting moment: moment\w* skręcając\w* (?:zastępcz|zredukowan)\w*
bending moment: moment\w* (?:gnąc|zginając)\w*
polar second moment of area: biegunow\w* moment\w* bezwładności|moment\w* bezwładności biegunow\w*
second moment of area: (?:osiow|geometryczn)\w* moment\w* bezwładności|moment\w* bezwładności przekroju
polar section modulus: wskaźnik\w* (?:wytrzymałości )?(?:przekroju )?na skręcanie
section modulus in bending: wskaźnik\w* (?:wytrzymałości )?(?:przekroju )?na zginanie
section modulus: wskaźnik\w* wytrzymałości(?: przekroju)?
moment of inertia: (?:masow\w* )?moment\w* bezwładności
torque: moment\w* (?:obrotow|skręcając|napędow)\w*
inertia force: sił\w? bezwładności
inertia couple: moment\w* sił bezwładności(?= (?:pierwsz|drugi|I))
first order: (?:pierwszego|I|1\.) rzędu
second order: (?:drugiego|II|2\.) rzędu
fourth order: (?:czwartego|IV|4\.) rzędu
centrifugal force: sił\w? odśrodkow\w+
reciprocating mass: mas\w+ (?:posuwisto-?\s?zwrotn\w+|w ruchu posuwisto-?\s?zwrotnym|oscylując\w+)
rotating mass: mas\w+ (?:wirując\w+|obracając\w+ się|w ruchu obrotowym)
rod mass: mas\w korbowodu
piston mass: mas\w tłoka
degree of irregularity: stop(?:ień|ni\w*) nierównomierności(?: biegu)?
degree of irregularity: współczynnik\w* nierównomierności(?: biegu)?
fluctuation of energy: nadwyżk\w+ pracy|wahani\w+ energii
kinetic energy: energi\w+ kinetyczn\w+
flywheel: koł\w+ zamachow\w+
shear modulus: moduł\w* (?:Kirchhoffa|sprężystości poprzecznej|ścinania)
bending stress: naprężeni\w* (?:gnąc\w+|zginając\w+|przy zginaniu|od zginania)
torsional stress: naprężeni\w* (?:skręcając\w+|styczn\w+ (?:przy|od) skręcani\w+|przy skręcaniu)
equivalent stress: naprężeni\w* (?:zastępcz|zredukowan)\w+
torsional stiffness: sztywnoś\w* (?:skrętn\w+|na skręcanie)
angle of twist: kąt\w* skręcenia
damped natural angular frequency: częstoś\w* drgań tłumionych
natural angular frequency: częstoś\w* (?:kołow\w+ )?(?:własn\w+|drgań własnych)|pulsacj\w+ własn\w+
natural frequency: częstotliwoś\w* (?:własn\w+|drgań własnych)
amplitude ratio: stosun\w+ amplitud
position of the node: położeni\w+ węzła|odległoś\w* węzła
node: węz\w+
critical speed: prędkoś\w* (?:obrotow\w+ )?krytyczn\w+
magnification factor: współczynnik\w* (?:wzmocnienia|zwielokrotnienia)(?: drgań| amplitudy)?
damping ratio: stop(?:ień|ni\w*) tłumienia|bezwymiarow\w+ współczynnik\w* tłumienia
logarithmic decrement: logarytmiczn\w+ dekrement\w*(?: tłumienia)?
critical damping: tłumieni\w+ krytyczn\w+
undamped: nietłumion\w+
damped: tłumion\w+
damping: tłumieni\w+
period: okres\w*
firing interval: odstęp\w* (?:między )?zapłon\w+|kąt\w* między zapłonami
firing frequency: częstotliwoś\w* zapłonów
counterweight: przeciwciężar\w*|przeciwwag\w+
balance shaft: wał\w* (?:wyrównoważając|wyważając)\w+
balance shafts: wał(?:y|ów|ki|ków) (?:wyrównoważając|wyważając)\w+
crank radius: promie(?:ń|ni\w*) (?:korby|wykorbienia)
connecting rod length: długoś\w* korbowodu
crank angle: kąt\w* (?:obrotu )?(?:korby|wału korbowego)|kąt\w* obrotu wału
rod angle: kąt\w* (?:odchylenia |wychylenia )?korbowodu
angular velocity of the rod: prędkoś\w* kątow\w+ korbowodu
angular acceleration of the rod: przyspieszeni\w* kątow\w+ korbowodu
angular velocity: prędkoś\w* kątow\w+
angular acceleration: przyspieszeni\w* kątow\w+
rotational speed: prędkoś\w* obrotow\w+
circumferential speed: prędkoś\w* obwodow\w+
mean effective pressure: średni\w+ ciśnieni\w+ (?:użyteczn\w+|efektywn\w+)
indicated mean effective pressure: średni\w+ ciśnieni\w+ indykowan\w+
mechanical efficiency: sprawnoś\w* mechaniczn\w+
efficiency: sprawnoś\w*
brake power: moc\w? (?:użyteczn\w+|efektywn\w+)
indicated power: moc\w? indykowan\w+
power: moc(?:y|ą)?
four-stroke: czterosuw\w*
two-stroke: dwusuw\w*
stroke: skok(?:u|iem)?
bore: średnic\w+ cylindra
top dead centre: (?:górn\w+|zewnętrzn\w+) (?:martwy\w*|martwym|zwrotny\w*) (?:punkt\w*|położeni\w+)|GMP
top dead centre: ZZ
bottom dead centre: (?:dolny|dolnym|dolnego) (?:martwy\w*|zwrotny\w*) (?:punkt\w*|położeni\w+)|DMP
bottom dead centre: DMP
radius of gyration: promie(?:ń|ni\w*) bezwładności
radius: promie(?:ń|nia|niu|niem)
diameter: średnic\w+
density: gęstoś\w*
mass: mas[aęyąo]
length: długoś\w*
thickness: gruboś\w*
force: sił[aęyąo]
forces: siłami|sił
pressure: ciśnieni\w+
area: pol[ea] (?:przekroju|powierzchni)|powierzchni\w*
stress: naprężeni\w*
stiffness: sztywnoś\w*
speed: prędkoś\w*
acceleration: przyspieszeni\w*
frequency: częstotliwoś\w*
energy: energi\w+
work of one cycle: prac\w (?:jednego )?(?:cyklu|obiegu)
work: prac[aęyą]
two discs: dw(?:a|óch|oma|ie) (?:dysk|tarcz|krążk|mas)\w*
thin ring: cienk\w+ (?:pierście\w+|obręcz\w*)
solid disc: pełn\w+ (?:dysk\w*|tarcz\w*)
disc: dysk\w*|tarcz\w*|krąż\w+
rim: wie(?:niec|ńca|ńcu)
shaft: wał(?:u|em|ek|ka)?
hollow: drążon\w+|rurow\w+|wydrążon\w+
fixed: utwierdzon\w+|zamocowan\w+
offset: przesunięt\w+ oś|mimośrodow\w+|niesymetryczn\w+
piston: tłok\w*
crankshaft: wał\w* korbow\w+
crank: korb(?:[ayęą]|ie)
connecting rod: korbow[oó]d\w*
engine: silnik\w*
cylinder: cylindr(?:a|ze|em|owi)|cylinder
cylinders: cylindr(?:y|ów|ach|ami)
single-cylinder: jednocylindrow\w+
both: ob(?:a|u|ie|ydwa|ydwu|ydwóch)
each: każd\w+
half: połow\w+|pół
per: na (?:jeden )?(?:cylinder|obrót)
total: całkowit\w+|łączn\w+
sum: sum[aęyą]
resultant: wypadkow\w+
relative: względn\w+
difference: różnic\w+
component: składow\w+
ratio: stosun\w+
parallel: równoleg\w+
series: szeregow\w+
largest: maksymaln\w+|największ\w+
smallest: minimaln\w+|najmniejsz\w+
mean: średni\w*
approximately: w przybliżeniu|około
wrong: błędn\w+
not: nie
from the: licząc od|mierzon\w+ od|od
is: jest(?: równ\w+)?|wynosi|równa się
are: są|wynoszą
and: oraz
with: przy
where: gdzie
at the top dead centre: w (?:górnym martwym (?:punkcie|położeniu)|górnym zwrotnym położeniu|GMP)
at the bottom dead centre: w (?:dolnym martwym (?:punkcie|położeniu)|dolnym zwrotnym położeniu|DMP)
on: na
between: między
for: dla
two: dw(?:a|ie|óch)
three: trzy|trzech
four: cztery|czterech
six: sześć|sześciu
centre of gravity: środ\w+ (?:ciężkości|masy)
pair: par[aęy]
proportional: proporcjonaln\w+
unit: jednost\w+
specific: właściw\w+
divided: podzielon\w+
squared: kwadrat\w*
square section: kwadratow\w+ przekr\w+
rectangular: prostokątn\w+
annular: pierścieniow\w+
solid: pełn\w+
amplitude: amplitud\w+
harmonic: harmoniczn\w+
coefficient: współczynnik\w*
distance: odległoś\w*|rozstaw\w*
height: wysokoś\w*
width: szerokoś\w*
gear: koł\w+ zębat\w+|przekładni\w*
pendulum: wahadł\w*
spring: sprężyn\w+
friction: tarci\w+
belt: pas(?:a|em|ek|owy|owa)
notch: karb\w*
thin-walled: cienkościenn\w+
rotating: wirując\w+|obracając\w+
dead centres: (?:martwych|martwe|zwrotnych|zwrotne) (?:punkt|położeni)\w+|punktach zwrotnych
if: jeśli|jeżeli
when: gdy|kiedy
another: inn(?:y|a|e|ego|ej)
case: przypad\w+
whereas: natomiast|podczas gdy
static deflection: ugięci\w+ statyczn\w+
deflection: ugięci\w+
in the middle: w (?:połowie|środku)
bearings: łożysk\w+
mass per length: mas\w+ (?:jednostki|na jednostkę) długości
three discs: trzy tarcze|trzech tarcz
absorber: (?:dynamiczn\w+ )?(?:eliminator\w* drgań|tłumik\w* dynamiczn\w+)
mass ratio: stosun\w+ mas
frequency ratio: stosun\w+ częstości
simple harmonic motion: ruch\w* harmoniczn\w+
"""
