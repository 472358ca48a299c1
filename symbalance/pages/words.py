"""The words of a page in English and in Japanese; the Japanese terms are those of the field."""
# Japanese letters are twice as wide as the linter takes them to be.
# ruff: noqa: E501

from __future__ import annotations

from dataclasses import replace

from symbalance.document.shapes import Drawing, Group, Label, Shape
from symbalance.errors import SymbalanceError, brief

ENGLISH = {
    "controls": "What the page shows",
    "run": "run",
    "stop": "stop",
    "reset": "the engine's own values",
    "theta": "crank angle θ",
    "lambda": "rod ratio λ",
    "bank": "angle between the banks",
    "reading": "the bank angle changes",
    "reading-crank": "the axes: same crank",
    "reading-firing": "the pins too: same firing",
    "share": "counterweights, share of the reciprocating mass",
    "weights": "the engine's weights and shafts, share",
    "rpm": "speed",
    "order": "order",
    "speed": "degrees a second",
    "section": "Cross-section, seen from the front",
    "plan": "Plan, the front to the left",
    "oblique": "Oblique view: drag it, or turn it with the arrow keys",
    "star": "Crank star of the order",
    "starAxis": "axis at @°",
    "starCloses": "closes: 0, proved",
    "starRounding": "closes to rounding",
    "starLeaves": "leaves # arrows at @°",
    "firing": "Firing order and strokes",
    "forces": "Free force over a turn",
    "couples": "Free couple over a turn",
    "path": "Path of the free force",
    "couple-path": "Path of the free couple",
    "phasors": "Free force of the order: its parts with and against the crank",
    "couple-phasors": "Free couple of the order: its parts with and against the crank",
    "orders": "Orders",
    "torque-figure": "Inertia torque over a turn",
    "noscript": "Without scripts the drawings stand still; tables and formulas are complete.",
    "unchecked": "Numbers from the library.",
    "checked": "The page's own kinematics and the library's functions agree at 64 angles, within @.",
    "differs": "The page's kinematics and the library's functions differ by @: do not rely on this page.",
    "angle": "crank angle θ",
    "force": "force",
    "couple": "couple",
    "verticalForce": "vertical force",
    "lateralForce": "lateral force",
    "verticalCouple": "vertical couple",
    "lateralCouple": "lateral couple",
    "vertical": "vertical",
    "lateral": "lateral",
    "torque": "inertia torque",
    "forward": "with the crank",
    "backward": "against it",
    "amplitude": "amplitude",
    "numeric": "numeric",
    "zeroProved": "cancels, proved",
    "zeroRounding": "cancels to rounding",
    "made": "Made by symbalance @. Everything on this page is in it: nothing is fetched.",
    "assumed": "Assumed for the drawings: @.",
    "now": "Now",
}

JAPANESE = {
    "controls": "表示の設定",
    "run": "自動回転",
    "stop": "停止",
    "reset": "元の値に戻す",
    "theta": "クランク角 θ",
    "lambda": "連桿比 λ",
    "bank": "バンク角",
    "reading": "バンク角の変え方",
    "reading-crank": "クランクはそのまま",
    "reading-firing": "クランクピンも動かす(点火間隔はそのまま)",
    "share": "カウンターウェイト(往復質量に対する割合、オーバーバランス)",
    "weights": "エンジンの釣合いおもりとバランスシャフト(割合)",
    "rpm": "回転数",
    "order": "次数",
    "speed": "毎秒の角度",
    "section": "横断図(前から見た図)",
    "plan": "平面図(左が前)",
    "oblique": "斜視図(ドラッグまたは矢印キーで回す)",
    "star": "クランクスター、次数",
    "starAxis": "シリンダー軸 @°",
    "starCloses": "閉じる:0(証明済み)",
    "starRounding": "丸め誤差の範囲で閉じる",
    "starLeaves": "矢印#本分が残る、@°",
    "firing": "点火順序と各気筒の行程",
    "forces": "慣性力(1回転)",
    "couples": "慣性偶力(1回転)",
    "path": "慣性力の軌跡",
    "couple-path": "慣性偶力の軌跡",
    "phasors": "この次数の慣性力:クランクと同じ向きに回る成分と逆向きに回る成分",
    "couple-phasors": "この次数の慣性偶力:クランクと同じ向きに回る成分と逆向きに回る成分",
    "orders": "次数ごとの大きさ",
    "torque-figure": "慣性トルク(1回転)",
    "noscript": "スクリプトが無効なので図は動きません。表と式はすべて表示されています。",
    "unchecked": "数値はライブラリのものです。",
    "checked": "このページの運動学とライブラリの関数は64個の角度で一致します(差 @ 以内)。",
    "differs": "このページの運動学とライブラリの関数に @ の差があります。このページを信用しないでください。",
    "angle": "クランク角 θ",
    "force": "慣性力",
    "couple": "慣性偶力",
    "verticalForce": "慣性力 鉛直",
    "lateralForce": "慣性力 水平",
    "verticalCouple": "慣性偶力 鉛直",
    "lateralCouple": "慣性偶力 水平",
    "vertical": "鉛直",
    "lateral": "水平",
    "torque": "慣性トルク",
    "forward": "同じ向き",
    "backward": "逆向き",
    "amplitude": "振幅",
    "numeric": "数値計算",
    "zeroProved": "0(証明済み)",
    "zeroRounding": "丸め誤差の範囲で0",
    "made": "symbalance @ で作成。必要なものはすべてこのファイルの中にあり、通信はしません。",
    "assumed": "図のための仮定:@。",
    "now": "現在値",
    # The words that stand in drawings.
    "power": "膨張",
    "exhaust": "排気",
    "intake": "吸気",
    "compression": "圧縮",
    "mean of stations": "中央",
    "crank angle θ ": "クランク角 θ",
    "* unlike the others": "* 不等間隔",
    "0, proved": "0(証明済み)",
    "closes: 0, proved": "閉じる:0(証明済み)",
}

LANGUAGES = {"en": ENGLISH, "ja": JAPANESE}


def words_of(language: str) -> dict[str, str]:
    """Return the words of a language, "en" or "ja"."""
    if language not in LANGUAGES:
        rule = f"must be one of {', '.join(LANGUAGES)}"
        raise SymbalanceError(f"lang = {brief(language)}", rule, "en is the default")
    return LANGUAGES[language]


def translated(drawing: Drawing, words: dict[str, str]) -> Drawing:
    """Return a drawing with those of its labels in another language that the words hold."""
    if words is ENGLISH:
        return drawing
    return replace(drawing, shapes=tuple(_translated(shape, words) for shape in drawing.shapes))


def _translated(shape: Shape, words: dict[str, str]) -> Shape:
    if isinstance(shape, Group):
        return replace(shape, shapes=tuple(_translated(each, words) for each in shape.shapes))
    if isinstance(shape, Label):
        first, _, rest = shape.text.partition(" ")
        if first in ("force", "couple") and rest.isdigit():
            return replace(shape, text=f"{words[first]} {rest}")
        return replace(shape, text=words.get(shape.text, shape.text))
    return shape
