//! Adaptive binary range coding: numbers that can be guessed take few bits.
//!
//! The coder of LZMA (Pavlov; after Martin, *Range encoding*, 1979): each yes or no takes a share of a
//! range as wide as it is likely, and what was seen makes it likelier next time.

/// Probabilities are in units of 2^-12.
const PROBABILITY_BITS: u32 = 12;
/// How slowly probabilities follow what is seen.
const ADAPTATION: u32 = 5;
/// Below this the range is widened by a byte.
const TOP: u32 = 1 << 24;

/// How likely a no is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Likelihood(u16);

impl Likelihood {
    pub(super) const EVEN: Self = Self(1 << (PROBABILITY_BITS - 1));

    /// The part of a range that stands for no.
    fn part(self, range: u32) -> u32 {
        (range >> PROBABILITY_BITS) * u32::from(self.0)
    }

    fn learn(&mut self, yes: bool) {
        if yes {
            self.0 -= self.0 >> ADAPTATION;
        } else {
            self.0 += ((1 << PROBABILITY_BITS) - self.0) >> ADAPTATION;
        }
    }
}

/// Most bits that one byte can stand for: the likeliest a bit gets is 1 − 31/4096, log2 of which is
/// 1/91 bit.
pub(super) const MAX_BITS_PER_BYTE: usize = 8 * 92;

#[derive(Debug)]
pub(super) struct Encoder {
    low: u64,
    range: u32,
    /// The last byte, which a carry may still change, and how many 255 follow it.
    last: u8,
    waiting: u64,
    bytes: Vec<u8>,
}

impl Encoder {
    pub(super) const fn new() -> Self {
        Self {
            low: 0,
            range: u32::MAX,
            last: 0,
            waiting: 1,
            bytes: Vec::new(),
        }
    }

    pub(super) fn bit(&mut self, likelihood: &mut Likelihood, yes: bool) {
        let part = likelihood.part(self.range);
        if yes {
            self.low += u64::from(part);
            self.range -= part;
        } else {
            self.range = part;
        }
        likelihood.learn(yes);
        while self.range < TOP {
            self.range <<= 8;
            self.shift();
        }
    }

    fn shift(&mut self) {
        if self.low < 0xff00_0000 || self.low > u64::from(u32::MAX) {
            let carry = (self.low >> 32) as u8;
            let mut byte = self.last;
            while self.waiting > 0 {
                self.bytes.push(byte.wrapping_add(carry));
                byte = 0xff;
                self.waiting -= 1;
            }
            self.last = (self.low >> 24) as u8;
        }
        self.waiting += 1;
        self.low = u64::from((self.low as u32) << 8);
    }

    pub(super) fn finish(mut self) -> Vec<u8> {
        (0..5).for_each(|_| self.shift());
        self.bytes
    }
}

#[derive(Debug)]
pub(super) struct Decoder<'a> {
    range: u32,
    code: u32,
    bytes: &'a [u8],
}

impl<'a> Decoder<'a> {
    /// Reads what [`Encoder::finish`] returned; any other bytes give numbers without meaning.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let mut decoder = Self {
            range: u32::MAX,
            code: 0,
            bytes,
        };
        (0..5).for_each(|_| decoder.code = decoder.code << 8 | decoder.byte());
        decoder
    }

    fn byte(&mut self) -> u32 {
        let Some((&byte, rest)) = self.bytes.split_first() else {
            return 0;
        };
        self.bytes = rest;
        u32::from(byte)
    }

    pub(super) fn bit(&mut self, likelihood: &mut Likelihood) -> bool {
        let part = likelihood.part(self.range);
        let yes = self.code >= part;
        if yes {
            self.code -= part;
            self.range -= part;
        } else {
            self.range = part;
        }
        likelihood.learn(yes);
        while self.range < TOP {
            self.range <<= 8;
            self.code = self.code << 8 | self.byte();
        }
        yes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_was_encoded_comes_back(bits in prop::collection::vec((0usize..3, any::<bool>()), 0..4000)) {
            let mut likelihoods = [Likelihood::EVEN; 3];
            let mut encoder = Encoder::new();
            for &(context, bit) in &bits {
                encoder.bit(&mut likelihoods[context], bit);
            }
            let bytes = encoder.finish();
            let mut likelihoods = [Likelihood::EVEN; 3];
            let mut decoder = Decoder::new(&bytes);
            for &(context, bit) in &bits {
                prop_assert_eq!(decoder.bit(&mut likelihoods[context]), bit);
            }
        }

        #[test]
        fn any_bytes_decode(bytes in prop::collection::vec(any::<u8>(), 0..50)) {
            let mut likelihood = Likelihood::EVEN;
            let mut decoder = Decoder::new(&bytes);
            (0..1000).for_each(|_| { decoder.bit(&mut likelihood); });
        }
    }

    #[test]
    fn what_repeats_takes_no_more_bits_than_said() {
        for yes in [false, true] {
            let mut likelihood = Likelihood::EVEN;
            let mut encoder = Encoder::new();
            let count = 1 << 20;
            (0..count).for_each(|_| encoder.bit(&mut likelihood, yes));
            let bytes = encoder.finish().len();
            assert!(bytes < 2000, "{bytes}");
            assert!(bytes * MAX_BITS_PER_BYTE > count, "{bytes}");
        }
    }
}
