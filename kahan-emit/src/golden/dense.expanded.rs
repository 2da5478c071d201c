impl<T> __kahan::Named for Dense<T> {
    fn variables(&self) -> &'static [&'static __kahan::str] {
        &Self::VARIABLES
    }
    fn parameters(&self) -> &'static [&'static __kahan::str] {
        &Self::PARAMETERS
    }
}
impl<T: __kahan::Scalar> __kahan::KahanMap<T, 6> for Dense<T> {
    type Prepared = __kahan::Elimination<Self, T>;
    #[inline]
    fn prepare(&self, eps: &T) -> Self::Prepared {
        __kahan::Elimination::new(self.clone(), eps.clone())
    }
    #[inline(always)]
    fn try_prepared(
        &self,
        prepared: &Self::Prepared,
        x: &__kahan::SVector<T, 6>,
        eps: &T,
    ) -> __kahan::Result<__kahan::SVector<T, 6>, __kahan::SingularStep>
    where
        T: __kahan::Pivot,
    {
        __kahan::Pivot::stable_step(self, prepared, x, eps)
    }
}
impl<T: __kahan::Scalar> __kahan::Lift<T, 6> for Dense<T> {
    type Lifted<U: __kahan::Scalar> = Dense<U>;
    #[inline(always)]
    fn lift<U: __kahan::Scalar>(&self, lift: impl __kahan::Fn(&T) -> U) -> Dense<U> {
        Dense {
            a: lift(&self.a),
            b: lift(&self.b),
            c: lift(&self.c),
        }
    }
}
