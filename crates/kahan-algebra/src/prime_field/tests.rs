use num_bigint::BigInt;

use kahan_syntax::rational::Rational;

use super::{PrimeField, Random, Shake256, SplitMix64, is_prime_u64, random_prime_61};

#[test]
fn primality_is_decided() {
    let sieve = |n: u64| n >= 2 && (2..).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d));
    for n in (0..3000).chain(65_000..66_500) {
        assert_eq!(is_prime_u64(n), sieve(n), "{n}");
    }
    for prime in [(1 << 61) - 1, 18_446_744_073_709_551_557, 4_611_686_018_427_387_847] {
        assert!(is_prime_u64(prime), "{prime}");
    }
    let composites =
        [3_215_031_751, 341_550_071_728_321, 3_825_123_056_546_413_051, 561, 66_049, 4_295_098_369, u64::MAX];
    for composite in composites {
        assert!(!is_prime_u64(composite), "{composite}");
    }
}

#[test]
fn random_primes_have_61_bits_and_follow_their_seed() {
    let draw = |seed: &[u8]| {
        let mut rng = SplitMix64::from_bytes(seed);
        [0; 3].map(|_| random_prime_61(&mut rng))
    };
    for prime in draw(b"kahan") {
        assert_eq!(64 - prime.leading_zeros(), 61);
        assert!(PrimeField::new(prime).is_some());
    }
    assert_eq!(draw(b"kahan"), draw(b"kahan"));
    assert_ne!(draw(b"kahan"), draw(b"Kahan"));
    assert_eq!(PrimeField::new(1 << 61), None);
    assert_eq!(PrimeField::new(18_446_744_073_709_551_557), None);
}

#[test]
fn residues_form_a_field() {
    let mut rng = SplitMix64::new(5);
    let field = PrimeField::random(&mut rng);
    for _ in 0..200 {
        let [a, b, c] = [0; 3].map(|_| field.sample(&mut rng));
        assert_eq!(field.mul(a, field.add(b, c)), field.add(field.mul(a, b), field.mul(a, c)));
        assert_eq!(field.sub(field.add(a, b), b), a);
        assert_eq!(field.add(a, field.neg(a)), 0);
        assert_eq!(field.inverse(a).map(|inverse| field.mul(a, inverse)), (a != 0).then_some(1));
        assert_eq!(field.pow(a, 5), field.mul(a, field.mul(field.mul(a, a), field.mul(a, a))));
        assert!(a < field.prime());
    }
    assert_eq!(field.inverse(0), None);
    assert_eq!(field.inverse(field.prime() - 1), Some(field.prime() - 1));
    assert_eq!((field.pow(0, 0), field.pow(3, field.prime() - 1)), (1, 1));
}

#[test]
fn reduction_is_a_homomorphism_and_refuses_the_prime_below() {
    let field = PrimeField::MERSENNE_61;
    let big = Rational::parse("-123456789012345678901234567890/77").unwrap();
    for a in [Rational::new(-3, 7), Rational::from(i64::MIN), big, Rational::ZERO] {
        for b in [Rational::new(5, 9), Rational::from(-1)] {
            let (x, y) = (field.reduce(&a).unwrap(), field.reduce(&b).unwrap());
            assert_eq!(field.reduce(&(&a * &b)), Some(field.mul(x, y)));
            assert_eq!(field.reduce(&(&a - &b)), Some(field.sub(x, y)));
        }
    }
    let prime = Rational::from(BigInt::from(field.prime()));
    assert_eq!(field.reduce(&prime), Some(0));
    assert_eq!(field.reduce(&prime.recip().unwrap()), None);
}

#[test]
fn the_generators_match_their_published_vectors() {
    let mut rng = SplitMix64::new(0);
    assert_eq!([rng.next_u64(), rng.next_u64()], [0xe220_a839_7b1d_cdaf, 0x6e78_9e6a_a1b9_65f4]);
    assert_eq!(SplitMix64::from_bytes(b"a").next_u64(), SplitMix64::new(0xaf63_dc4c_8601_ec8c).next_u64());
    // The values are from Python's `hashlib.shake_256`.
    let words = |text: &[u8], from: usize| {
        let mut stream = Shake256::new(text);
        let mut words = std::iter::repeat_with(|| stream.next_u64()).skip(from);
        [(); 2].map(|()| words.next().expect("the digest has no end"))
    };
    assert_eq!(words(b"", 0), [0x138d_a80b_2bdd_b946, 0x24eb_3e74_eb3f_3b23]);
    assert_eq!(words(b"abc", 0), [0x77a8_6013_6066_3348, 0x4d11_c40c_0863_681c]);
    assert_eq!(words(b"abc", 16), [0x29cc_a771_ecd7_a2e8, 0x581a_ffee_10a6_0ecf]);
    assert_eq!(words(&[b'a'; 135], 0), [0xb667_e5e1_ec91_b955, 0x01d2_4d44_14c7_c2e7]);
    assert_eq!(words(&[b'a'; 136], 0), [0x82f6_a1f0_085a_cc8f, 0x046e_d1e8_4ef6_9c7c]);
    assert_eq!(words(&[b'a'; 300], 0), [0x37e4_18ca_3843_2e54, 0x8f15_b6a2_0743_8376]);
    let mut counts = [0; 5];
    for _ in 0..1000 {
        counts[usize::try_from(rng.below(5)).unwrap()] += 1;
    }
    assert!(counts.iter().all(|count| (150..250).contains(count)), "{counts:?}");
}

#[test]
fn the_points_of_a_proof_depend_on_each_bit_of_their_seed() {
    let primes = (0..=256).map(|bit| {
        let mut seed = [0; 32];
        if let Some(byte) = seed.get_mut(bit / 8) {
            *byte = 1 << (bit % 8);
        }
        random_prime_61(&mut Shake256::new(&seed))
    });
    let distinct: std::collections::BTreeSet<u64> = primes.collect();
    assert_eq!(distinct.len(), 257);
    let seed = |text: &str| crate::seed(&kahan_syntax::lexer::lex(text).tokens);
    assert_ne!(seed("xdot = x;"), seed("xdot = y;"));
    assert_eq!(seed("xdot = x;"), seed("xdot  =x ;"));
}
