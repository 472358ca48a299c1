"""Portuguese terms of engines, shafts and vibrations."""

OF = r"(?:do\s+|da\s+|dos\s+|das\s+|de\s+um\s+|de\s+)"
TERMS = r"""
mean piston speed: velocidade média §(?:pistão|êmbolo)
largest piston speed: velocidade máxima §(?:pistão|êmbolo)
piston velocity: velocidade (?:instantânea )?§(?:pistão|êmbolo)
largest piston acceleration: aceleração máxima §(?:pistão|êmbolo)
piston acceleration: aceleração (?:instantânea )?§(?:pistão|êmbolo)
piston displacement: deslocamento §(?:pistão|êmbolo)
piston position: posição §(?:pistão|êmbolo)
piston area: (?:área|superfície|secção|seção) §(?:pistão|êmbolo)
swept volume: cilindrada(?: unitária)?
compression ratio: (?:taxa|razão|relação) (?:volumétrica )?§compressão
clearance volume: volume morto|volume §câmara de combustão
gas force: força (?:devida à pressão )?§(?:gás|gases)
side thrust: (?:força|reação|reacção) lateral|(?:impulso|empuxo|esforço) lateral
connecting rod force: (?:força|esforço) (?:na |sobre a |§)biela
tangential force: (?:força|esforço) tangencial
radial force: (?:força|esforço) radial
piston force: força (?:sobre o |no |§)(?:pistão|êmbolo)
mean torque: (?:torque|binário) médio
inertia torque: (?:torque|binário) (?:de inércia|§forças de inércia)
engine torque: (?:torque|binário) (?:motor|§motor)
equivalent twisting moment: momento torsor equivalente|torque equivalente
equivalent bending moment: momento fletor equivalente|momento flector equivalente
bending moment: momento flec?tor
torque: torque|binário(?! de (?!torção))|momento torsor|momento de torção
inertia couple: (?:binário|momento|conjugado)s? de inércia(?= (?:de )?(?:primeira|segunda|1|2))
inertia force: forças? de inércia
primary force: forças? primárias?
secondary force: forças? secundárias?
first order: (?:primeira|1ª) ordem|ordem (?:1|um)
second order: (?:segunda|2ª) ordem|ordem (?:2|dois)
fourth order: (?:quarta|4ª) ordem|ordem (?:4|quatro)
centrifugal force: forças? centrífugas?
reciprocating mass: massas? (?:alternativas?|oscilantes?|em movimento alternativo)
rotating mass: massas? (?:rotativas?|rotantes?|girantes?|em rotação)
rod mass: massa §biela
piston mass: massa §(?:pistão|êmbolo)
degree of irregularity: (?:grau|coeficiente) de (?:irregularidade|flutuação(?: de velocidade)?)
fluctuation of energy: flutuação (?:de|da) energia|variação (?:máxima )?(?:de|da) energia
kinetic energy: energia cinética
flywheel: volante(?: de inércia)?
polar moment of inertia: momento polar de inércia|momento de inércia polar
moment of inertia: momentos? de inércia
inertia: inércia
second moment of area: segundo momento de área|momento de inércia da sec?ção
polar section modulus: módulo de resistência (?:polar|à torção)
section modulus in bending: módulo de resistência à flexão
section modulus: módulo de resistência
shear modulus: módulo de (?:cisalhamento|elasticidade transversal|corte)
shear stress: tensão (?:de cisalhamento|tangencial|cisalhante)(?: máxima)?
bending stress: tensão (?:normal )?(?:de|por|na|devida à) flexão
torsional stress: tensão (?:de cisalhamento |tangencial )?(?:de|por|na|devida à) torção
equivalent stress: tensão equivalente
torsional stiffness: rigidez (?:torcional|torsional|à torção)
angle of twist: ângulo de torção
damped natural angular frequency: frequência (?:angular |circular |natural )*amortecida
natural angular frequency: frequência (?:angular|circular) (?:natural|própria)
natural angular frequency: frequência (?:natural|própria) (?:angular|circular)|pulsação própria
natural frequency: frequências? (?:natura(?:l|is)|próprias?)
amplitude ratio: (?:relação|razão) (?:de|das|entre as) amplitudes
position of the node: (?:posição|distância) §(?:nó|nodo)
critical speed: velocidades? críticas?|rotação crítica
magnification factor: fator de (?:amplificação|ampliação)|factor de amplificação
damping ratio: (?:fator|razão|taxa|coeficiente) de amortecimento(?: relativo)?
logarithmic decrement: decremento logarítmico
critical damping: amortecimento crítico
damping: amortecimento
undamped: não amortecid\w*|sem amortecimento
damped: amortecid\w*
period: período
firing interval: intervalo (?:angular )?de ignição
firing interval: intervalo entre (?:duas )?(?:ignições|explosões)(?: consecutivas| sucessivas)?
firing frequency: frequência de (?:ignição|explosão)
counterweight: contrapesos?
balance shaft: (?:eixo|veio|árvore) (?:balanceador|de balanceamento|de equilíbrio|de equilibragem)
balance shafts: (?:eixos|veios) (?:balanceadores|de balanceamento|de equilíbrio|de equilibragem)
crank radius: raio §(?:manivela|virabrequim|cambota)
connecting rod length: comprimento §biela
crank angle: ângulo §(?:primeira )?(?:manivela|virabrequim|cambota)
rod angle: (?:ângulo|obliquidade|inclinação) §biela
angular velocity of the rod: velocidade angular §biela
angular acceleration of the rod: aceleração angular §biela
angular velocity: velocidade angular
angular acceleration: aceleração angular
rotational speed: velocidade de rotação|rotação|regime
circumferential speed: velocidade (?:periférica|circunferencial)
mean effective pressure: pressão média efec?tiva
indicated mean effective pressure: pressão média indicada
mechanical efficiency: rendimento mecânico|eficiência mecânica
efficiency: rendimento|eficiência
brake power: potência efec?tiva
indicated power: potência indicada
power: potência
four-stroke: (?:de |a )?(?:quatro|4) tempos
two-stroke: (?:de |a )?(?:dois|2) tempos
stroke: curso
bore: diâmetro do cilindro
top dead centre: ponto morto superior|PMS|p\.\s?m\.\s?s\.?
bottom dead centre: ponto morto inferior|PMI|p\.\s?m\.\s?i\.?
dead centre: ponto morto
radius of gyration: raio de giração
angle: ângulos?
radius: raio
diameter: diâmetro
density: densidade|massa específica
mass: massa
length: comprimento
thickness: espessura
force: força
forces: forças
pressure: pressão
area: área
stiffness: rigidez
speed: velocidade
acceleration: aceleração
frequency: frequência
energy: energia
work of one cycle: trabalho (?:por|de um|§) ?ciclo
work: trabalho
two discs: dois (?:discos|volantes)|duas inércias
thin ring: (?:anel|aro) (?:fino|delgado)
solid disc: disco (?:maciço|sólido)
disc: disco
rim: aro
shaft: eixo|veio|árvore
hollow: oc[oa]|vazad[oa]|tubular
fixed: engastad\w*|encastrad\w*
offset: descentrad\w*|deslocad\w*|excêntric\w*
piston: pistão|êmbolo
crankshaft: virabrequim|cambota
crank: manivela
connecting rod: biela
engine: motor
cylinder: cilindro
cylinders: cilindros
single-cylinder: monocilíndric\w*|monocilindro
four cylinders: (?:quatro|4) cilindros
six cylinders: (?:seis|6) cilindros
three cylinders: (?:três|3) cilindros
two cylinders: (?:dois|2) cilindros
both: ambos|ambas|os dois|as duas
each: cada
half: metade|meio
per: por(?= (?:cilindro|volta|rotação|unidade|metro|segundo))
total: total|totais|global
sum: soma
resultant: resultante
relative: relativ[oa]
difference: diferença
component: componente
ratio: razão|relação
parallel: paralelo
series: série
largest: máxim[oa]|maior
smallest: mínim[oa]|menor
mean: médi[oa]
approximately: aproximadamente
wrong: errad\w*
is not: não é
from the: a partir §|desde (?:o |a )?
about its diameter: em relação a um diâmetro
is: é|vale|resulta
are: são
at the: no|ao
the: os|as
a: uma?
of: do|da|dos|das|de
with: com
where: onde
in: em|na
between: entre
for: para
by: por|pelo|pela
on: sobre
two: dois|duas
three: três
four: quatro
six: seis
centre of gravity: centro de (?:gravidade|massa)
pair: par de (?:cilindros|pistões|discos)|pares
proportional: proporciona(?:l|is)
unit: unidade|unitári[oa]
specific: específic[oa]
divided: dividid[oa]
squared: ao quadrado|quadrado
square section: sec?ção quadrada|seção quadrada
rectangular: retangular
annular: anelar|anular
solid: maciç[oa]
amplitude: amplitude
harmonic: harmônic[oa]|harmónic[oa]
coefficient: coeficiente
distance: distância
height: altura
width: largura
gear: engrenagem
pendulum: pêndulo
spring: mola
springs: molas
friction: atrito
belt: correia
notch: entalhe
thin-walled: parede fina
rotating: rotativ[oa]s?|girantes?
uneven: irregular(?:es)?
dead centres: pontos mortos
at the: na
when: quando
another: outr[oa]
case: caso
whereas: enquanto
static deflection: (?:flecha|deflexão) estática
deflection: flecha|deflexão
critical speed of bending: velocidade crítica (?:de|à) flexão
in the middle: no (?:centro|meio)|a meio d\w*
simply supported: (?:simplesmente|bi-?)\s?apoiad\w*|apoiad\w*
bearings: mancais|apoios|rolamentos
bearing: mancal|apoio|rolamento
mass per length: massa por unidade de comprimento
angular frequency: frequência angular(?! (?:natural|própria|amortecida))|pulsação(?! própria)
diametrically opposite: diametralmente opost\w*
vibrates freely: oscila livremente|vibra livremente
three discs: três (?:discos|volantes|massas)
two-node mode: modo (?:de|com) dois nós
absorber: absorvedor(?: dinâmico)?
mass ratio: (?:razão|relação) de massas
transmissibility: transmissibilidade
frequency ratio: (?:razão|relação) de frequências
simple harmonic motion: movimento harmônico(?: simples)?
bifilar suspension: (?:suspensão|pêndulo) bifilar
trifilar suspension: (?:suspensão|pêndulo) trifilar
small oscillations: pequenas oscilações
lag: atraso(?: de fase)?
with their signs: com (?:o )?seus? sina(?:l|is)
"""
