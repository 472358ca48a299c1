"""Spanish terms of engines, shafts and vibrations."""

OF = r"(?:del\s+|de\s+la\s+|de\s+los\s+|de\s+las\s+|de\s+un\s+|de\s+)"
TERMS = r"""
mean piston speed: velocidad (?:lineal )?media §(?:pistón|émbolo)
largest piston speed: velocidad máxima §(?:pistón|émbolo)
piston velocity: velocidad (?:instantánea )?§(?:pistón|émbolo)
largest piston acceleration: aceleración máxima §(?:pistón|émbolo)
piston acceleration: aceleración (?:instantánea )?§(?:pistón|émbolo)
piston displacement: (?:desplazamiento|descenso|recorrido|camino) §(?:pistón|émbolo)
piston position: posición §(?:pistón|émbolo)
piston area: (?:área|superficie|sección) §(?:pistón|émbolo)
swept volume: cilindrada(?: unitaria)?
compression ratio: relación (?:volumétrica )?§compresión|relación volumétrica
clearance volume: volumen muerto|volumen §cámara de combustión
gas force: fuerza (?:debida a la presión )?§gas(?:es)?|fuerza debida a los gases
side thrust: (?:empuje|esfuerzo) lateral|fuerza lateral|reacción lateral|empuje normal
connecting rod force: (?:fuerza|esfuerzo) (?:en la |sobre la |§)biela
tangential force: (?:fuerza|esfuerzo) tangencial
radial force: (?:fuerza|esfuerzo) radial
piston force: fuerza (?:sobre el |§)(?:pistón|émbolo)
mean torque: par (?:motor )?medio
inertia torque: par de inercia|par §fuerzas de inercia
engine torque: par (?:motor|§motor)
equivalent twisting moment: momento torsor equivalente|par equivalente|momento de torsión equivalente
equivalent bending moment: momento flector equivalente
bending moment: momento flector
torque: par (?:torsor|instantáneo|resistente|transmitido)|momento torsor|momento de torsión
the torque: (?:el|un|este) par(?! (?:medio|motor|torsor|de (?!torsión|giro|apriete)))
couple: par(?= de (?:primer|segundo))|par de fuerzas
pair: par de (?:cilindros|pistones|discos|ruedas|masas|ejes)|pareja
inertia couple: (?:par|momento)s? de inercia(?= (?:de )?(?:primer|segundo|1|2))
inertia force: (?:fuerza|esfuerzo)s? de inercia
primary force: fuerzas? primarias?
secondary force: fuerzas? secundarias?
first order: (?:primer|1er) orden|orden (?:1|uno)
second order: (?:segundo|2º|2\.º) orden|orden (?:2|dos)
fourth order: (?:cuarto|4º|4\.º) orden|orden (?:4|cuatro)
centrifugal force: fuerzas? centrífugas?
reciprocating mass: masas? (?:alternativas?|oscilantes?|en movimiento alternativo)
rotating mass: masas? (?:rotativas?|rotantes?|giratorias?|en rotación)
rod mass: masa §biela
piston mass: masa §(?:pistón|émbolo)
to the big end: (?:a|desde|hasta) la cabeza(?: de (?:la )?biela)?
to the small end: (?:al|desde el|hasta el) pie(?: de (?:la )?biela)?
big end: cabeza de (?:la )?biela
small end: pie de (?:la )?biela
gudgeon pin: bulón|pasador del pistón
crank pin: muñequilla|muñón de biela
degree of irregularity: (?:grado|coeficiente) de (?:irregularidad|fluctuación(?: de (?:la )?velocidad)?)
fluctuation of energy: fluctuación de (?:la )?energía|variación (?:máxima )?de (?:la )?energía
fluctuation of energy: exceso de trabajo
kinetic energy: energía cinética
flywheel: volante(?: de inercia)?
polar moment of inertia: momento polar de inercia|momento de inercia polar
moment of inertia: momentos? de inercia
inertia: inercia
second moment of area: segundo momento de área|momento de inercia de la sección
polar section modulus: módulo (?:resistente )?(?:polar|a (?:la )?torsión|de torsión)
section modulus in bending: módulo resistente a (?:la )?flexión
section modulus: módulo resistente|módulo de la sección
shear modulus: módulo de (?:cizalladura|cortadura|rigidez|corte)
shear stress: (?:tensión|esfuerzo) (?:cortante|tangencial|de (?:cortadura|cizalladura))(?: máxim[ao])?
shear stress: (?:tensión|esfuerzo) máxim[ao] de (?:cortadura|cizalladura)
bending stress: (?:tensión|esfuerzo) (?:normal )?(?:de|por|a) flexión
torsional stress: (?:tensión|esfuerzo) (?:cortante |tangencial )?(?:de|por|a) torsión
equivalent stress: (?:tensión|esfuerzo) equivalente
torsional stiffness: rigidez (?:torsional|(?:a|de) (?:la )?torsión)|constante torsional
angle of twist: ángulo de (?:torsión|giro por torsión)
damped natural angular frequency: (?:pulsación|frecuencia angular) (?:propia |natural )?amortiguada
natural angular frequency: pulsaci(?:ón|ones) (?:propia|natural)(?:es|s)?
natural angular frequency: frecuencia (?:angular|circular) (?:natural|propia)
natural angular frequency: frecuencia (?:natural|propia) (?:angular|circular)
natural frequency: frecuencias? (?:natural(?:es)?|propias?)
amplitude ratio: (?:relación|cociente) de (?:las )?amplitudes
position of the node: (?:posición|distancia) §nodo
node: nodo
critical speed: velocidad(?:es)? críticas?|régimen crítico
magnification factor: factor de amplificación|coeficiente de amplificación
damping ratio: (?:factor|razón|coeficiente|relación) de amortiguamiento(?: relativo)?
logarithmic decrement: decremento logarítmico
critical damping: amortiguamiento crítico
damping: amortiguamiento
undamped: no amortiguad\w*|sin amortiguamiento
damped: amortiguad\w*
period: per[ií]odo
firing interval: intervalo (?:angular )?de encendido
firing interval: intervalo entre (?:dos )?(?:encendidos|explosiones)(?: consecutiv\w*| sucesiv\w*)?
firing frequency: frecuencia de (?:encendido|explosi[oó]n(?:es)?)
power strokes per revolution: carreras (?:útiles|motrices|de trabajo) por (?:vuelta|revolución)
power strokes per revolution: (?:explosiones|encendidos|combustiones) por (?:vuelta|revolución)
counterweight: contrapesos?
balance shaft: (?:eje|árbol) (?:de equilibrado|equilibrador|compensador)
balance shafts: (?:ejes|árboles) (?:de equilibrado|equilibradores|compensadores)
crank radius: radio §(?:manivela|cigüeñal)
connecting rod length: longitud §biela
crank angle: ángulo §(?:primera )?(?:manivela|cigüeñal)(?: girado)?
rod angle: (?:ángulo|oblicuidad|inclinación) §biela
angular velocity of the rod: velocidad angular §biela
angular acceleration of the rod: aceleración angular §biela
angular velocity: velocidad angular
angular acceleration: aceleración angular
rotational speed: velocidad de (?:giro|rotación)|régimen(?: de giro)?
circumferential speed: velocidad (?:periférica|circunferencial)
mean effective pressure: presión media efectiva
indicated mean effective pressure: presión media indicada
mechanical efficiency: rendimiento mecánico
efficiency: rendimiento
brake power: potencia efectiva
indicated power: potencia indicada
power: potencia
four-stroke: (?:de )?(?:cuatro|4) tiempos
two-stroke: (?:de )?(?:dos|2) tiempos
stroke: carrera
bore: diámetro del cilindro
top dead centre: punto muerto superior|PMS|p\.\s?m\.\s?s\.?
bottom dead centre: punto muerto inferior|PMI|p\.\s?m\.\s?i\.?
dead centre: punto muerto
radius of gyration: radio de (?:giro|inercia)
friction mean effective pressure: presión media (?:efectiva )?de (?:fricción|rozamientos?|pérdidas)
angle: ángulos?
radius: radio
diameter: diámetro
density: densidad
mass: masa
length: longitud
thickness: espesor
force: fuerza
forces: fuerzas
pressure: presión
area: área|superficie
stiffness: rigidez
speed: velocidad
acceleration: aceleración
frequency: frecuencia
energy: energía
work of one cycle: trabajo (?:por|de un|§) ?ciclo
work: trabajo
two discs: dos (?:discos|volantes|inercias)
thin ring: (?:anillo|aro) delgado
solid disc: disco macizo
disc: disco
rim: llanta|corona
shaft: eje|árbol
hollow: huec[oa]|tubular
fixed: empotrad\w*
offset: descentrad\w*|desalinead\w*|descentramiento|excéntric\w*
piston: pistón|émbolo
crankshaft: cigüeñal
crank: manivela
connecting rod: biela
engine: motor
cylinder: cilindro
cylinders: cilindros
single-cylinder: monocilíndric\w*|monocilindro
four cylinders: (?:cuatro|4) cilindros
six cylinders: (?:seis|6) cilindros
three cylinders: (?:tres|3) cilindros
two cylinders: (?:dos|2) cilindros
both: ambos|ambas|los dos|las dos
each: cada
half: mitad|medio
per: por(?= (?:cilindro|vuelta|revolución|unidad|metro|segundo))
total: total(?:es)?|global
sum: suma
resultant: resultante
relative: relativ[oa]
difference: diferencia
component: componente
ratio: relación|cociente
parallel: paralelo
series: serie
largest: máxim[oa]|mayor
smallest: mínim[oa]|menor
mean: medi[oa]
approximately: aproximadamente
wrong: erróne\w*|falso
is not: no es
from the: desde (?:el |la )?|a partir §
about its diameter: respecto (?:a|de) (?:un|su) diámetro
is: es|vale|resulta|está
are: son
at the: en el|al
the: el|la|los|las
a: una?
of: del?
with: con
where: donde
in: en
between: entre
for: para
by: por
on: sobre
two: dos
three: tres
four: cuatro
six: seis
residual force along the line of stroke: fuerza residual (?:en|según) (?:la dirección|el eje)
residual force along the line of stroke: fuerza residual según el eje del cilindro
residual force perpendicular to it: fuerza residual (?:perpendicular|transversal)(?: al eje)?
balance shafts: ejes? contrarrotantes?
centre of gravity: centro de (?:gravedad|masas?)
proportional: proporcional\w*
unit: unidad|unitari[oa]
specific: específic[oa]
divided: dividid[oa]
squared: al cuadrado|cuadrado
square section: sección cuadrada
rectangular: rectangular
annular: anular
solid: maciz[oa]|llen[oa]
amplitude: amplitud
harmonic: armónic[oa]
coefficient: coeficiente
distance: distancia
height: altura
width: anchura|ancho
gear: engranaje
pendulum: péndulo
spring: muelle|resorte
springs: muelles|resortes
friction: rozamiento|fricción
belt: correa
notch: entalla
thin-walled: pared delgada
rotating: rotativ[oa]s?|giratori[oa]s?
uneven: irregular(?:es)?
dead centres: puntos muertos
if: si
when: cuando
another: otr[oa]
case: caso
whereas: mientras que
static deflection: (?:flecha|deflexión|deformación) estática
deflection: flecha|deflexión
critical speed of bending: velocidad crítica (?:de|a) flexión
in the middle: en (?:el|su) (?:centro|medio)|a mitad de
simply supported: simplemente apoyad\w*|apoyad\w* en sus extremos
bearings: cojinetes|apoyos|rodamientos
bearing: cojinete|apoyo|rodamiento
mass per length: masa por unidad de longitud|masa lineal
angular frequency: pulsación|frecuencia (?:angular|circular)(?! (?:natural|propia|amortiguada))
diametrically opposite: diametralmente opuest\w*
vibrates freely: oscila libremente|vibra libremente
three discs: tres (?:discos|volantes|masas|inercias)
two-node mode: modo (?:de|con) dos nodos
absorber: absorbedor(?: dinámico)?|amortiguador dinámico
mass ratio: (?:razón|relación|cociente) de masas
transmissibility: transmisibilidad
frequency ratio: (?:razón|relación|cociente) de frecuencias
simple harmonic motion: movimiento armónico(?: simple)?
bifilar suspension: (?:suspensión|péndulo) bifilar
trifilar suspension: (?:suspensión|péndulo) trifilar
small oscillations: pequeñas oscilaciones
lag: retraso(?: de fase)?|desfase en retraso
with their signs: con su signo|con sus signos
"""
