"""Technical terms of eight languages with what they are called in English, a language a module.

Each line of a module's `TERMS` is an English term and, behind a colon, what stands for it: stems with
`\\w*`, alternatives between bars. A `§` stands for the words for "of", with or without an article.
"""
