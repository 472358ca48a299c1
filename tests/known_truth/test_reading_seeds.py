"""Every displayed equation of four hand-written derivations, as written, and what it says.

Each block holds the lines of one chain and, after =>, its sides as the reader renders them, the
equation's number in round brackets and the reader's remarks in square ones.
"""
# ruff: noqa: E501

from __future__ import annotations

import pytest

from symbalance.document.latex_writer import formula_latex
from symbalance.document.text_writer import formula_text
from symbalance.notes.reading import read_document, read_expression
from symbalance.notes.reading.equations import Chain, Document

ONE_CYLINDER_LETTERS = """theta beta s lambda l x X n omega v a F M Mw rw Fw Fwv Fwh N h S u alpha L R Lh Lv Rh Rv M1 M2 M3"""
ONE_CYLINDER = r"""
\displaystyle \frac{s}{2} \sin \theta
=> s/2 sin θ

\displaystyle x=\frac{s}{2}(1-\cos \theta)+\lambda s(1-cos \beta)
=> x = s/2 (1 - cos θ) + λ s (1 - cos β)

\displaystyle l \sin \beta=\frac{s}{2} \sin \theta
=> l sin β = s/2 sin θ

\displaystyle \sin \beta=\frac{s}{2l} \sin \theta=\frac{\sin \theta}{2 \lambda}
=> sin β = s/(2l) sin θ = sin(θ)/(2λ)

\displaystyle \cos \beta=\sqrt { 1-\sin ^2 \beta}=\sqrt { 1-(\frac{\sin \theta }{2 \lambda})^2}
\displaystyle =\sqrt { 1-\frac{\sin ^2 \theta }{4 \lambda ^2}}
=> cos β = sqrt(1 - sin^2 β) = sqrt(1 - (sin(θ)/(2λ))^2) = sqrt(1 - sin^2(θ)/(4 λ^2))

\displaystyle x=\frac{s}{2} (1-\cos \theta) +\lambda s (1-\sqrt { 1-\frac{\sin ^2 \theta }{4 \lambda ^2}})
=> x = s/2 (1 - cos θ) + λ s (1 - sqrt(1 - sin^2(θ)/(4 λ^2)))

\displaystyle Y=\sqrt(1-X)= 1-\frac{X}{2} - \frac{X^2}{8}-\frac{X^3}{16}-\frac{5X^4}{128}-\frac{7X^5}{256} - \cdot \cdot \cdot
=> Y = sqrt(1 - X) = 1 - X/2 - X^2/8 - X^3/16 - 5 X^4/128 - 7 X^5/256 + … [\sqrt( ) read as the root of the bracket]

\displaystyle X=\frac{\sin ^2 \theta }{4 \lambda ^2}
=> X = sin^2(θ)/(4 λ^2)

\displaystyle x=\frac{s}{2} (1-\cos \theta) +\lambda s (\frac{\sin^2 \theta}{2*4 \lambda^2}+\frac{\sin^4 \theta}{8*4^2 \lambda^4}+\frac{\sin^6 \theta}{16*4^3 \lambda^6} \cdot \cdot \cdot)
\displaystyle =\frac{s}{2} (1-\cos \theta) +\lambda s (\frac{\sin^2 \theta}{8\lambda^2}+\frac{\sin^4 \theta}{128\lambda^4}+\frac{\sin^6 \theta}{1024\lambda^6} \cdot \cdot \cdot)
=> x = s/2 (1 - cos θ) + λ s (sin^2(θ)/(2*4 λ^2) + sin^4(θ)/(8*4^2 λ^4) + sin^6(θ)/(16*4^3 λ^6) + …) = s/2 (1 - cos θ) + λ s (sin^2(θ)/(8 λ^2) + sin^4(θ)/(128 λ^4) + sin^6(θ)/(1024 λ^6) + …)

\displaystyle x \fallingdotseq \frac{s}{2} (1-\cos \theta) +\lambda s (\frac{\sin^2 \theta}{8 \lambda^2}+ \frac{\sin^4 \theta}{128\lambda^4}+ \frac{\sin^6 \theta}{1024\lambda^6})
=> x ≈ s/2 (1 - cos θ) + λ s (sin^2(θ)/(8 λ^2) + sin^4(θ)/(128 λ^4) + sin^6(θ)/(1024 λ^6))

\displaystyle \sin ^2 \theta=\frac{1-cos 2\theta}{2}
=> sin^2 θ = (1 - cos 2θ)/2

\displaystyle sin ^4 \theta=\frac{3- 4 \cos 2 \theta + \cos 4 \theta}{8}
=> sin^4 θ = (3 - 4 cos 2θ + cos 4θ)/8

\displaystyle sin ^6 \theta={{-\cos \left(6\,\theta \right)+6\,\cos \left(4\, \theta \right)-15\,\cos \left( 2\,\theta \right)+10}\over{32}}
=> sin^6 θ = (-cos 6θ + 6 cos 4θ - 15 cos 2θ + 10)/32

\displaystyle x \fallingdotseq \frac{s}{2} (1-\cos \theta) + \frac{s}{16\lambda}(1-\cos 2 \theta)
\displaystyle +\frac{s}{128 \lambda^3}\frac{3-4 \cos 2 \theta + \cos 4\theta}{8}
\displaystyle +\frac{s}{1024 \lambda^5}\frac{-\cos 6\theta + 6 \cos 4 \theta -15 \cos 2 \theta + 10}{32}
\displaystyle =\frac{s}{2} (1-\cos \theta) + \frac{s}{16\lambda}(1-\cos 2 \theta)
\displaystyle +\frac{3s}{1024 \lambda^3} -\frac{4s}{1024 \lambda^3} \cos 2 \theta +\frac{s}{1024 \lambda^3} \cos 4 \theta
\displaystyle -\frac{s}{32768 \lambda^5} \cos 6 \theta + \frac{6s}{32768 \lambda^5} \cos 4 \theta - \frac{15s}{32768 \lambda^5} \cos 2 \theta +\frac{10s}{32768 \lambda^5}
\displaystyle =\frac{s}{2} (1-\cos \theta) + \frac{s}{16\lambda}(1-\cos 2 \theta)
\displaystyle -\frac{4s}{1024 \lambda^3} \cos 2 \theta - \frac{15s}{32768 \lambda^5} \cos 2 \theta
\displaystyle +\frac{2}{1024 \lambda^3} \cos 4 \theta + \frac{6s}{32768 \lambda^5} \cos 4 \theta
\displaystyle -\frac{s}{32768 \lambda^5} \cos 6 \theta
\displaystyle +\frac{3s}{1024 \lambda^3}+\frac{10s}{32768 \lambda^5}
=> x ≈ s/2 (1 - cos θ) + s/(16λ) (1 - cos 2θ) + s/(128 λ^3) ((3 - 4 cos 2θ + cos 4θ)/8) + s/(1024 λ^5) ((-cos 6θ + 6 cos 4θ - 15 cos 2θ + 10)/32) = s/2 (1 - cos θ) + s/(16λ) (1 - cos 2θ) + 3s/(1024 λ^3) - 4s/(1024 λ^3) cos 2θ + s/(1024 λ^3) cos 4θ - s/(32768 λ^5) cos 6θ + 6s/(32768 λ^5) cos 4θ - 15s/(32768 λ^5) cos 2θ + 10s/(32768 λ^5) = s/2 (1 - cos θ) + s/(16λ) (1 - cos 2θ) - 4s/(1024 λ^3) cos 2θ - 15s/(32768 λ^5) cos 2θ + 2/(1024 λ^3) cos 4θ + 6s/(32768 λ^5) cos 4θ - s/(32768 λ^5) cos 6θ + 3s/(1024 λ^3) + 10s/(32768 λ^5)

x \fallingdotseq \frac{s}{2} (1-\cos \theta) + \frac{s}{16\lambda}(1-\cos 2 \theta)
=> x ≈ s/2 (1 - cos θ) + s/(16λ) (1 - cos 2θ)

\displaystyle \omega = \frac{\pi n}{30}
=> ω = π n/30

\displaystyle x= \frac{s}{2} (1-\cos \theta) +\frac{s}{16 \lambda}(1-\cos 2\theta)
=> x = s/2 (1 - cos θ) + s/(16λ) (1 - cos 2θ)

\displaystyle v=\frac{dx}{d \theta}=\frac{\omega s}{2} \sin \theta + \frac{\omega s \sin 2 \theta}{8 \lambda}
\displaystyle =\frac{\omega s}{2} (\sin \theta + \frac{1}{4 \lambda} \sin 2 \theta)
\displaystyle =\frac{\omega s}{2} (\sin \theta + \frac{1}{4 \lambda} \sin 2 \theta)
\displaystyle +\frac{\omega s}{2} (\frac{8s}{1024 \lambda^3}\sin 2\theta+\frac{30s}{32768 \lambda^5} \sin 2 \theta
\displaystyle -\frac{8s}{1024 \lambda^3}\sin 4\theta-\frac{24s}{32768 \lambda^5}\sin 4 \theta
\displaystyle +\frac{6s}{32768 \lambda^5} \cos 6\theta )
=> v = dx/dθ = ω s/2 sin θ + ω s sin(2θ)/(8λ) = ω s/2 (sin θ + 1/(4λ) sin 2θ) = ω s/2 (sin θ + 1/(4λ) sin 2θ) + ω s/2 (8s/(1024 λ^3) sin 2θ + 30s/(32768 λ^5) sin 2θ - 8s/(1024 λ^3) sin 4θ - 24s/(32768 λ^5) sin 4θ + 6s/(32768 λ^5) cos 6θ)

\displaystyle v=\frac{\omega s}{2} (\sin \theta+\frac{1}{4 \lambda} \cos 2 \theta )
=> v = ω s/2 (sin θ + 1/(4λ) cos 2θ)

\displaystyle a=\frac{\omega^2 s}{2} (\cos \theta+ \frac{1}{2 \lambda} \cos 2 \theta)
=> a = ω^2 s/2 (cos θ + 1/(2λ) cos 2θ)

\displaystyle a=\frac{\omega^2 s}{2} (\cos \theta
\displaystyle +\frac{1}{2 \lambda} \cos 2 \theta+ \frac{1}{64 \lambda^3} \cos 2\theta+\frac{15}{4096 \lambda^5} \cos 2\theta
\displaystyle -\frac{1}{32 \lambda^3} \cos 4\theta-\frac{3}{1024 \lambda^5} \cos 4 \theta
\displaystyle +\frac{9}{8192 \lambda^5} \cos 6\theta)
=> a = ω^2 s/2 (cos θ + 1/(2λ) cos 2θ + 1/(64 λ^3) cos 2θ + 15/(4096 λ^5) cos 2θ - 1/(32 λ^3) cos 4θ - 3/(1024 λ^5) cos 4θ + 9/(8192 λ^5) cos 6θ)

\displaystyle a=\frac{\omega^2 s}{2} (\cos \theta+ \frac{1}{2 \lambda} \cos 2 \theta)
=> a = ω^2 s/2 (cos θ + 1/(2λ) cos 2θ)

\displaystyle F=M \cdot a=M \frac{\omega^2 s}{2} (\cos \theta+ \frac{1}{2 \lambda} \cos 2 \theta)
=> F = M a = M (ω^2 s/2) (cos θ + 1/(2λ) cos 2θ)

\displaystyle F=M \cdot a=M \frac{\omega^2 s}{2} (\cos \theta
\displaystyle +\frac{1}{2 \lambda} \cos 2 \theta+ \frac{1}{64 \lambda^3} \cos 2\theta+\frac{15}{4096 \lambda^5} \cos 2\theta
\displaystyle -\frac{1}{32 \lambda^3} \cos 4\theta-\frac{3}{1024 \lambda^5} \cos 4 \theta
\displaystyle +\frac{9}{8192 \lambda^5} \cos 6\theta)
\displaystyle =M \cdot a=M \frac{\omega^2 s}{2} (\cos \theta
\displaystyle +( \frac{1}{2 \lambda} + \frac{1}{64 \lambda^3} +\frac{15}{4096 \lambda^5}) \cos 2\theta
\displaystyle -(\frac{1}{32 \lambda^3} +\frac{3}{1024 \lambda^5}) \cos 4 \theta
\displaystyle +\frac{9}{8192 \lambda^5} \cos 6\theta)
=> F = M a = M (ω^2 s/2) (cos θ + 1/(2λ) cos 2θ + 1/(64 λ^3) cos 2θ + 15/(4096 λ^5) cos 2θ - 1/(32 λ^3) cos 4θ - 3/(1024 λ^5) cos 4θ + 9/(8192 λ^5) cos 6θ) = M a = M (ω^2 s/2) (cos θ + (1/(2λ) + 1/(64 λ^3) + 15/(4096 λ^5)) cos 2θ - (1/(32 λ^3) + 3/(1024 λ^5)) cos 4θ + 9/(8192 λ^5) cos 6θ)

Fw=Mw \cdot \omega ^2 rw
=> Fw = Mw ω^2 rw

Fwv=Mw \cdot \omega ^2 rw \cos \theta
=> Fwv = Mw ω^2 rw cos θ

Fwh=Mw \cdot \omega ^2 rw \sin \theta
=> Fwh = Mw ω^2 rw sin θ

\displaystyle h=\frac{4 \pi}{N}
=> h = 4 π/N

\displaystyle S=\cos n \theta + \cos n(\theta+h)+ \cdot \cdot \cdot \cos n(\theta+(h (N-1)))
\displaystyle =\frac{\sin N \frac{nh}{2}}{\sin \frac{nh}{2}} \cos n(\theta + \frac{N-1}{2}h)
=> S = cos(n θ) + cos(n (θ + h)) + … + cos(n (θ + h (N - 1))) = sin(N (n h/2))/sin(n h/2) cos(n (θ + (N - 1)/2 h))

\displaystyle \frac{\sin N \frac{nh}{2}}{\sin \frac{nh}{2}}=\frac{\sin 2 \pi n}{\sin (n \frac{2 \pi}{N})}
=> sin(N (n h/2))/sin(n h/2) = sin(2 π n)/sin(n (2 π/N))

\displaystyle u=\frac{2n}{N}
=> u = 2n/N

\displaystyle Lh=L \cos \alpha=\frac{ \sqrt 3}{2} L
=> Lh = L cos α = sqrt(3)/2 L

\displaystyle Lv=L \sin \alpha=\frac{1}{2} L
=> Lv = L sin α = 1/2 L

\displaystyle Rh=R \cos \alpha=\frac{ \sqrt 3}{2} R
=> Rh = R cos α = sqrt(3)/2 R

\displaystyle Rv=R \sin \alpha=\frac{1}{2} R
=> Rv = R sin α = 1/2 R

\cos \theta
=> cos θ

M1=a \cos \theta
=> M1 = a cos θ

M2=0
=> M2 = 0

\displaystyle \cos (\theta - \frac{1}{3} \pi)
=> cos(θ - 1/3 π)

\displaystyle M3=-a \cos (\theta-\frac{1}{3} \pi )
=> M3 = -a cos(θ - 1/3 π)

\displaystyle M=M1+M2+M2=a \cos \theta-a \cos (\theta-\frac{1}{3} \pi )
\displaystyle =-a \sqrt 3 \sin (\theta -\frac{1}{3} \pi)
=> M = M1 + M2 + M2 = a cos θ - a cos(θ - 1/3 π) = -a sqrt(3) sin(θ - 1/3 π)

\displaystyle -\frac{M \omega ^2 s}{2} a \sqrt 3 \sin (\theta -\frac{1}{3} \pi)
=> -M ω^2 s/2 a sqrt(3) sin(θ - 1/3 π)
"""

TWELVE_CYLINDERS_LETTERS = """theta L R Lh Lv Rh Rv alpha F M omega lambda"""
TWELVE_CYLINDERS = r"""
\displaystyle Lh=L \cos \alpha=\frac{ \sqrt 3}{2} L
=> Lh = L cos α = sqrt(3)/2 L

\displaystyle Lv=L \sin \alpha=\frac{1}{2} L
=> Lv = L sin α = 1/2 L

\displaystyle Rh=R \cos \alpha=\frac{ \sqrt 3}{2} R
=> Rh = R cos α = sqrt(3)/2 R

\displaystyle Rv=R \sin \alpha=\frac{1}{2} R
=> Rv = R sin α = 1/2 R

6 \cos 6 \theta
=> 6 cos 6θ

\displaystyle \cos (\frac{1}{6} \pi )6 \cos 6 \theta=\frac{\sqrt 3}{2} 6 \cos 6 \theta
=> cos(1/6 π)*6 cos 6θ = sqrt(3)/2*6 cos 6θ

3 \sqrt 3 \cos 6 \theta
=> 3 sqrt(3) cos 6θ

\displaystyle 6 \cos (6 \theta-\frac{1}{3} \pi)
=> 6 cos(6θ - 1/3 π)

\displaystyle \cos (\frac{1}{6} \pi )6 \cos (6 \theta-\frac{1}{3} \pi)=\frac{\sqrt 3}{2} 6 \cos (6 \theta-\frac{1}{3} \pi)
=> cos(1/6 π)*6 cos(6θ - 1/3 π) = sqrt(3)/2*6 cos(6θ - 1/3 π)

\displaystyle 3 \sqrt 3 \cos (6 \theta-\frac{1}{3} \pi)
=> 3 sqrt(3) cos(6θ - 1/3 π)

\displaystyle 3 \sqrt 3 ( \cos 6 \theta + \cos (6 \theta-\frac{1}{3} \pi))
\displaystyle =3 \sqrt 3 (2 \cos (\frac{12 \theta -\frac{1}{3} \pi}{2}) \cos \frac{\frac{1}{3} \pi}{2})
\displaystyle =3 \sqrt 3 (2 \cos (6 \theta -\frac{1}{6} \pi) \cos (\frac{1}{6} \pi))
\displaystyle =3 \sqrt 3 (2 \cos (6 \theta -\frac{1}{6} \pi) \frac{\sqrt 3}{2})
\displaystyle =9 \cos (6 \theta -\frac{1}{6} \pi))
\displaystyle =9 \cos (6 \theta -\frac{1}{6} \pi)
=> 3 sqrt(3) (cos 6θ + cos(6θ - 1/3 π)) = 3 sqrt(3) (2 cos((12θ - 1/3 π)/2) cos(1/3 π/2)) = 3 sqrt(3) (2 cos(6θ - 1/6 π) cos(1/6 π)) = 3 sqrt(3) (2 cos(6θ - 1/6 π) (sqrt(3)/2)) = 9 cos(6θ - 1/6 π) = 9 cos(6θ - 1/6 π) [stray ) dropped]

\displaystyle F=M \omega^2 \frac{81}{16384 \lambda^5} \cos (6 \theta -\frac{1}{6} \pi)
=> F = M ω^2 (81/(16384 λ^5)) cos(6θ - 1/6 π)

\displaystyle \sin(\frac{1}{6} \pi)(-6 \cos 6 \theta + 6 \cos (6 \theta -\frac{\pi}{3} ))
\displaystyle =-6\sin(\frac{1}{6} \pi)(\cos 6 \theta - \cos (6 \theta -\frac{\pi}{3} ))
\displaystyle =6\sin(\frac{1}{6} \pi) 2 \sin (6 \theta - \frac{1}{6} \pi) \sin(\frac{1}{6} \pi )
\displaystyle =12 \frac{1}{2} \frac{1}{2} \sin (6 \theta - \frac{1}{6} \pi)
\displaystyle =3 \sin (6 \theta - \frac{1}{6} \pi)
=> sin(1/6 π) (-6 cos 6θ + 6 cos(6θ - π/3)) = -6 sin(1/6 π) (cos 6θ - cos(6θ - π/3)) = 6 sin(1/6 π)*2 sin(6θ - 1/6 π) sin(1/6 π) = 12 (1/2) (1/2) sin(6θ - 1/6 π) = 3 sin(6θ - 1/6 π)

\displaystyle F=M \omega^2 \frac{27}{16384 \lambda^5} \sin (6 \theta - \frac{1}{6} \pi)
=> F = M ω^2 (27/(16384 λ^5)) sin(6θ - 1/6 π)
"""

BALANCE_WEIGHTS_LETTERS = (
    """S t r omega theta lambda alpha m_p m_1 m_2 r_1 r_2 m_i r_i m_4 r_4 F G_y G_x m_5 F_1 F_2"""
)
BALANCE_WEIGHTS = r"""
$$m_1 \times r_1 = m_2 \times r_2 \quad - (1)$$
=> m_1 r_1 = m_2 r_2 (1)

$$\text{このとき、} \quad \sum (m_i \times r_i) = m_4 \times r_4 \quad - (2)$$
=> Σ m_i r_i = m_4 r_4 (2)

$$\frac{d^2S}{dt^2} = r\omega^2(\cos\theta + 1/\lambda \cos 2\theta + \dots) = \alpha \quad - (3)$$
=> d^2S/dt^2 = r ω^2 (cos θ + 1/λ cos 2θ + …) = α (3)

$$F = -m_p \alpha = -m_p r \omega^2 \cos\theta \quad - \quad m_p r \omega^2 \times 1/\lambda \cos 2\theta \quad - (4)$$
=> F = -m_p α = -m_p r ω^2 cos θ - m_p r ω^2 (1/λ) cos 2θ (4)

$$G_y = m_5 r \omega^2 \cos\theta \quad - (5)$$
=> G_y = m_5 r ω^2 cos θ (5)

$$G_x = m_5 r \omega^2 \sin\theta \quad - (6)$$
=> G_x = m_5 r ω^2 sin θ (6)

$$F_1 + G_y = -m_p r \omega^2 \cos\theta + m_5 r \omega^2 \cos\theta = 0 \quad - (7)$$
=> F_1 + G_y = -m_p r ω^2 cos θ + m_5 r ω^2 cos θ = 0 (7)
"""

PLAIN_TEXT_LETTERS = """r l x rho omega W F q4 q6 theta p3 p5 n M L Q I"""
PLAIN_TEXT = r"""
    x  = r cosθ + l sqrt(1 - ρ sin^2θ),
=> x = r cos θ + l sqrt(1 - ρ sin^2 θ)

    x/r = cosθ
        + [ρ/4 + (ρ^3)/16 + (ρ^5)/512] cos 2θ
        - [(ρ^3)/64 + + 3(ρ^5)/256] cos 4θ
        + [(ρ^5)/512] cos 6θ,
=> x/r = cos θ + (ρ/4 + ρ^3/16 + ρ^5/512) cos 2θ - (ρ^3/64 + 3 ρ^5/256) cos 4θ + ρ^5/512 cos 6θ [+ + read as +]
"""

DERIVATIONS = {
    "one cylinder": (ONE_CYLINDER, ONE_CYLINDER_LETTERS),
    "twelve cylinders": (TWELVE_CYLINDERS, TWELVE_CYLINDERS_LETTERS),
    "balance weights": (BALANCE_WEIGHTS, BALANCE_WEIGHTS_LETTERS),
    "plain text": (PLAIN_TEXT, PLAIN_TEXT_LETTERS),
}

PROSE = [
    ("角度 (θ=90度) のとき", ["θ = 90 (π/180)"]),
    ("比は 147.15/(73.3/2)=4.02", ["147.15/(73.3/2) = 4.02"]),
    ("ρ = r/l として、一般に 1/3 < ρ < 1/5 であり、", ["ρ = r/l", "1/3 < ρ < 1/5"]),
    ("仮に ρ = 1/4 とすると、二次 1/16、四次 1/4096 となる。", ["ρ = 1/4"]),
    ("質量を W とすると力は F = Wr(ω^2) である。", ["F = W r ω^2"]),
    ("但し q4 = -(1/4)ρ^3、q6 = (9/128)ρ^5 である。", ["q4 = -1/4 ρ^3", "q6 = 9/128 ρ^5"]),
    ("L を距離として、M = FL で表す。", ["M = F L"]),
    ("力は Q = I(ω^2) である。", ["Q = I ω^2"]),
    ("* 比は、ρ=1/4 としたときの F cos nθ の係数である。", ["ρ = 1/4"]),
    ("設計し、 $m_5 (= m_p / 2)$ の軸と $m_5 = m_p$ と $m_5 r$ は", ["m_5 = m_p/2", "m_5 = m_p"]),
    (r"成分 $F_2 = m_p r \omega^2 \times 1/\lambda \cos 2\theta$ は", ["F_2 = m_p r ω^2 (1/λ) cos 2θ"]),
    (
        r"成分に\displaystyle \cos \frac{1}{6} \pi=\frac{\sqrt 3}{2} を乗じる。",
        ["cos(1/6 π) = sqrt(3)/2"],
    ),
    ("間隔は720度/12=60度である。", ["720 (π/180)/12 = 60 (π/180)"]),
    ("角度θ=", []),
    ("順序は 1-2-9-10-5-6 とする。", []),
    ("2 1 2 4 6", []),
    ("直6 --> V8 --> V6 と変わる。", []),
    ("直3sqrt(3)M cos(θ-π/6) sqrt(3)Mρcos(2θ+π/6)3M q4 cos(4θ-π/6)01.79", []),
    ("角速度 ω について cos 2ω, cos 3ω, …の成分がある。", []),
    ("R Rh Rv α L Lh -Lh Lv α 0 x y の図", []),
    ("回転数はn(rpm)で、角度差は4π/Nとする。", []),
    ("#1#2#3#4", []),
    ("<参考文献>", []),
]


def document(text: str, letters: str) -> Document:
    return read_document(text, "notes.txt", lambda line: letters.split())


def said(chain: Chain) -> str:
    text = formula_text(chain.sides[0].node, plain=True)
    for relation, side in zip(chain.relations, chain.sides[1:], strict=True):
        text += f" {relation.sign} {formula_text(side.node, plain=True)}"
    tag = f" ({chain.tag})" if chain.tag else ""
    return text + tag + "".join(f" [{note}]" for note in chain.notes)


BLOCKS = [
    pytest.param(block, letters, id=f"{name} {place}")
    for name, (text, letters) in DERIVATIONS.items()
    for place, block in enumerate(text.strip("\n").split("\n\n"), 1)
]


@pytest.mark.parametrize(("block", "letters"), BLOCKS)
def test_an_equation_of_a_derivation(block: str, letters: str) -> None:
    source, _, expected = block.partition("\n=> ")
    read = document(source, letters)
    assert [said(chain) for chain in read.chains] == [expected]
    assert not read.unreadable
    assert read.chains[0].lines == tuple(range(1, source.count("\n") + 2))
    assert not read.chains[0].inline


@pytest.mark.parametrize(("block", "letters"), BLOCKS)
def test_its_sides_are_rendered_as_they_read(block: str, letters: str) -> None:
    source = block.partition("\n=> ")[0]
    names = [*letters.split(), "Y", "X", "h", "S", "u"]
    for side in document(source, letters).chains[0].sides:
        text = formula_text(side.node, plain=True)
        assert formula_text(read_expression(text, names)[0], plain=True) == text
        assert formula_text(read_expression(formula_latex(side.node), names)[0], plain=True) == text


@pytest.mark.parametrize(("line", "expected"), PROSE)
def test_a_line_of_prose(line: str, expected: list[str]) -> None:
    letters = f"{BALANCE_WEIGHTS_LETTERS} {PLAIN_TEXT_LETTERS} n W"
    read = document(line, letters)
    assert [said(chain) for chain in read.chains] == expected
    assert all(chain.inline for chain in read.chains)
    assert not read.unreadable


def test_a_chain_goes_on_over_a_line_of_prose() -> None:
    lines = [
        "\\displaystyle v=a",
        "\\displaystyle =s",
        "2次以降も含めると以下の通りとなる。",
        "\\displaystyle =x",
        "+l",
    ]
    (chain,) = document("\n".join(lines), ONE_CYLINDER_LETTERS).chains
    assert said(chain) == "v = a = s = x + l"
    assert chain.lines == (1, 2, 4, 5)
    assert [relation.line for relation in chain.relations] == [1, 2, 4]
